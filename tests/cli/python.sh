#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# python/matvib.py against the program: the numbers are those of the tables, refusals are exceptions, and the notebook's cells run.
# shellcheck source=tests/common.sh
. "$MATVIB_SRCDIR/tests/common.sh"

if ! command -v python3 >/dev/null 2>&1; then
	skip "matvib from Python" "no python3"
	echo "1..$number"
	exit
fi
PYTHONPATH=$MATVIB_SRCDIR/python PYTHONDONTWRITEBYTECODE=1
export PYTHONPATH PYTHONDONTWRITEBYTECODE MATVIB
python() { # NAME: standard input is a program that ends by an assertion
	cat >program.py
	result "$1" python3 program.py
}
"$MATVIB" run mode1 --steps 20 --series own.csv --quiet
python "a series has the numbers of its file" <<'END'
import csv, matvib
own = list(csv.DictReader(open("own.csv")))
series = matvib.series("mode1", steps=20)
assert [float(row["v_cm"]) for row in own] == list(series["v_cm"]) and len(own) == 21
END
python "a summary has quantities by name" <<'END'
import matvib
summary = matvib.run({"scenario": "mode5", "mesh.cell_size": 0.5}, end=20)
assert abs(summary["frequency_exact"] - 5.654866776) < 1e-8 and -1.2 < summary["frequency_error"] < -1
END
python "a number of another type is a number" <<'END'
import matvib
class Float64(float):
    def __repr__(self):
        return "np.float64(%r)" % float(self)
assert matvib.run("mode5", steps=3, set={"mesh.cell_size": Float64(0.5)})["steps"] == 3
END
python "particles at several times" <<'END'
import matvib
assert sorted(set(matvib.particles("mode1", steps=20, at=[0, 0.1])["step"])) == [0, 10]
END
python "a right table is right, a wrong one is a mistake" <<'END'
import matvib
right = matvib.diagnose("mode1", "own.csv")
assert right["verdict"] == "right" and right["scheme"] == "USF", right
wrong = matvib.series("mode1", steps=40, set={"mpm.mistake": "volume_of_cell"}, columns="all")
wrong = matvib.diagnose("mode1", {name: wrong[name] for name in ("time", "v_cm", "kinetic", "strain")})
assert wrong["verdict"] == "mistake" and wrong["mistake"] == ["volume_of_cell"], wrong
END
python "a fit finds the parameter" <<'END'
import matvib
fitted = matvib.fit("mode1", "own.csv", ["bar.youngs_modulus"], set={"bar.youngs_modulus": 90}, steps=20)
assert abs(fitted["bar.youngs_modulus"]["value"] - 100) < 1e-3, fitted
assert fitted["bar.youngs_modulus"]["half_width_95"] >= 0 and fitted["bar.youngs_modulus"]["began_at"] == 90, fitted
END
python "each pair of parameters has a correlation" <<'END'
import matvib
fitted = matvib.fit("mode1", "own.csv", ["bar.youngs_modulus", "bar.density", "initial.velocity"], steps=20)
pairs = [(pair["of"], pair["and"]) for pair in fitted["correlation"]]
assert len(set(pairs)) == 3 and ("bar.youngs_modulus", "bar.density") in pairs, fitted
END
python "a refusal is an exception with the message and its status" <<'END'
import matvib
try:
    matvib.run("mode1", set={"bar.length": -1})
except matvib.MatvibError as refused:
    assert refused.status == 2 and "bar.length" in str(refused), refused
else:
    raise AssertionError
END
python "the notebook runs" <<'END'
import json, os
names = {}
for cell in json.load(open(os.environ["MATVIB_SRCDIR"] + "/python/matvib.ipynb"))["cells"]:
    if cell["cell_type"] == "code":
        exec("".join(cell["source"]), names)
assert names["right"]["verdict"] == "right" and names["right"]["scheme"] == "USL", names["right"]
assert names["wrong"]["mistake"] == ["volume_of_cell"], names["wrong"]
assert 3.3 < names["errors"][1] / names["errors"][0.5] < 4.7, names["errors"]
assert len(names["series"]["v_cm_exact"]) == len(names["series"]["time"]) == 1201
assert abs(names["fitted"]["value"] - 110) < 3 * names["fitted"]["half_width_95"] < 0.1, names["fitted"]
END
echo "1..$number"
