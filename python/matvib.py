# SPDX-License-Identifier: GPL-3.0-or-later
"""matvib from Python: each function runs the program and returns what it computes.

    import matvib
    summary = matvib.run("mode5", end=20, set={"mesh.cell_size": 0.5})
    series = matvib.series("mode5", end=20)          # columns by name: series["v_cm"]
    verdict = matvib.diagnose("mode5", "mine.csv")

A scenario is a built-in name, a path, or a dict {"bar.length": 25, ...}. Tables are pandas.DataFrame where pandas is
installed, else a dict of lists of float. The program is the one that the variable MATVIB of the environment names, else
`matvib` of the path. What it refuses raises MatvibError with its message.
"""
import csv
import io
import json
import os
import subprocess
import tempfile

try:
    import pandas
except ImportError:
    pandas = None

__all__ = ["MatvibError", "run", "series", "particles", "diagnose", "fit", "table"]


class MatvibError(Exception):
    """The program's message, and its exit status: 1 the run failed, 2 bad input."""

    def __init__(self, message, status):
        super().__init__(message)
        self.status = status


def _call(words, allowed=(0,)):
    try:
        done = subprocess.run([os.environ.get("MATVIB", "matvib"), *words], stdin=subprocess.DEVNULL,
                              capture_output=True, text=True, encoding="utf-8", check=False)
    except FileNotFoundError as missing:
        raise MatvibError(f"{missing.filename}: not found (set MATVIB to the program's path)", 127) from None
    if done.returncode not in allowed:
        lines = done.stderr.strip().splitlines()
        raise MatvibError(lines[-1] if lines else f"exit status {done.returncode}", done.returncode)
    return done.stdout


def _words(command, scenario, **options):
    """The words of a command; the keyword `set` is a dict of parameters, True an option without a value."""
    changed = dict(options.pop("set", None) or {})
    if isinstance(scenario, dict):
        changed, scenario = {**scenario, **changed}, scenario.get("scenario", "mode5")
        changed.pop("scenario", None)
    words = [command, os.fspath(scenario)]
    for key, value in changed.items():
        words += ["--set", f"{key}={_text(value)}"]
    for name, value in options.items():
        if value is None or value is False:
            continue
        words.append("--" + name.replace("_", "-"))
        if value is not True:
            words.append(_text(value))
    return words


def _text(value):
    if isinstance(value, (list, tuple)):
        return ",".join(_text(item) for item in value)
    return repr(float(value)) if isinstance(value, float) else str(value)


def table(text):
    """A table of the program: text columns stay text, an empty field is not a number."""
    rows = list(csv.reader(io.StringIO(text)))
    columns = {name: [] for name in rows[0]}
    for row in rows[1:]:
        for name, field in zip(columns, row):
            columns[name].append(_number(field))
    return pandas.DataFrame(columns) if pandas else columns


def _number(field):
    try:
        return float(field) if field else float("nan")
    except ValueError:
        return field


def _quantities(text):
    answer = json.loads(text)
    numbers = {item["name"]: item["value"] for item in answer.pop("quantities", [])}
    return {**answer, **numbers}


def run(scenario, **options):
    """The summary of a run: {"frequency_measured": ..., "frequency_exact": ..., "energy_left": ...}."""
    return _quantities(_call(_words("run", scenario, json=True, **options)))


def series(scenario, **options):
    """One row for each recorded step; every=N, columns="all" or a list of names."""
    return table(_call(_words("run", scenario, series="-", quiet=True, **options)))


def particles(scenario, **options):
    """All particles at the end; frames=N or at=[t, ...] for several times."""
    return table(_call(_words("run", scenario, particles="-", quiet=True, **options)))


def diagnose(scenario, data, **options):
    """The verdict on the numbers of a code: a dict with verdict, scheme, mistake, digits, read_as. `data` is a path, or a
    table (DataFrame, or dict of columns)."""
    if isinstance(data, (str, os.PathLike)):
        return json.loads(_call(_words("diagnose", scenario, json=True, **options) + [os.fspath(data)], (0, 1)))[0]
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "data.csv")
        columns = {name: list(data[name]) for name in data}
        with open(path, "w", newline="", encoding="utf-8") as file:
            out = csv.writer(file)
            out.writerow(columns)
            out.writerows(map(_fields, zip(*columns.values())))
        return diagnose(scenario, path, **options)


def _fields(row):
    return [repr(float(value)) for value in row]


def fit(scenario, data, vary, **options):
    """The parameters that a measured series asks for: path of the CSV file, keys to vary. A dict of quantities by name, each
    with value, unit and, of a parameter, half_width_95 and began_at; "correlation" is a list with one for each pair."""
    answer = json.loads(_call(_words("fit", scenario, data=os.fspath(data), vary=_text(vary), json=True, **options)))
    found = {"correlation": []}
    for item in answer["quantities"]:
        name = item.pop("name")
        if name == "correlation":
            found[name].append(item)
        else:
            found[name] = item
    return found
