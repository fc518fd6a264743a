# SPDX-License-Identifier: GPL-3.0-or-later
"""What the programs of this folder share: the cases of a golden file, and whether digits agree with them.

A golden file has cases, "case NAME" to the next one, of lines of words; a line behind # is a remark.
"""
import os
import sys

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "golden")


def lines(name):
    """The lines of a golden file, each a list of words."""
    with open(os.path.join(FOLDER, name)) as file:
        return [line.split() for line in file if line.strip() and not line.startswith("#")]


def cases(name):
    """(name, lines) of each case of a golden file."""
    found = []
    for words in lines(name):
        if words[0] == "case":
            found.append((words[1], [words]))
        elif words[0] != "end":
            found[-1][1].append(words)
    return found


def settings(case):
    """The lines "set KEY VALUE" of a case."""
    return {words[1]: " ".join(words[2:]) for words in case if words[0] == "set"}


def numbers(words):
    return [float(word) for word in words]


class Comparison:
    """Counts the digits of one case that were looked at, and keeps the worst of them."""

    failed = 0

    def __init__(self, name):
        self.name, self.count, self.worst, self.what = name, 0, 0.0, "nothing"

    def near(self, what, got, expected, allowed):
        """Whether got is expected, but for `allowed`; 0 means equal."""
        off = abs(got - expected)
        share = off / allowed if allowed > 0 else (0.0 if off == 0 else float("inf"))
        self.count += 1
        if not share <= self.worst:
            self.worst, self.what = share, f"{what}: {got!r}, golden {expected!r}"

    def tell(self):
        """One line of the test protocol."""
        good = self.count > 0 and self.worst <= 1
        Comparison.failed += not good
        print(f"{'ok' if good else 'not ok'} - {self.name}: {self.count} numbers, the worst at {self.worst:.2g}"
              f" of what is allowed{'' if good else ' (' + self.what + ')'}", flush=True)


def end():
    sys.exit(1 if Comparison.failed else 0)
