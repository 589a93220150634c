#!/usr/bin/env python3
"""Compares pictures after changes of a scene with those of a mapper that has drawn nothing before.

Usage: test_state.py setters                           every setter is tried, or left out for a reason
       test_state.py [--quick | --setter NAME] KIND...                 each change, there and back, and with another
       test_state.py --rounds N [--seed S] [KIND...]   N rounds of one to three changes by chance
"""

import argparse
import random
import sys

import numpy
from kinds import KINDS
from left_out import LEFT_OUT, left_out
from own import OWN
from scenes import Scene, new_window
from setters import Change, automatic, mutators
from vtkmodules.vtkCommonCore import vtkObject

# A view rests when it has been drawn as often, and until then its picture differs by no more.
DRAWINGS_TO_REST = 10
LARGEST_BEFORE_REST = 16  # of 255
# Nodes of lattices are traced by the ray that asks first, whose lane rounds in its own way.
LARGEST_BY_ROUNDING = 1  # of 255


def own_changes(scene, target):
    """Changes of an object that no signature tells, as far as the object has the methods."""
    for setter, make, undo in OWN.get(target, ()):
        if hasattr(scene[target], setter.split("(")[0]):
            yield Change(target, setter, f"{setter}(...)", make, undo)


def changes_of(scene):
    """All changes of a scene's objects, and the methods that none of them calls."""
    changes, missing = [], []
    for target in scene.changed():
        thing = scene[target]
        own = list(own_changes(scene, target))
        called = {change.setter for change in own}
        changes += own
        for name in mutators(thing):
            if left_out(target, name):
                continue
            made = automatic(target, thing, name) if name not in called else []
            changes += made
            # A second object of a kind is tried by values alone.
            if not made and name not in called and not target.startswith("other "):
                missing.append(f"{target}.{name}")
    return changes, missing


class Comparison:
    """A scene that is drawn again and again, beside scenes that are drawn once."""

    def __init__(self, kind):
        self.kind = KINDS[kind]
        self.window = new_window()  # of scenes that are drawn once
        self.faults = []
        self.seen = set()  # setters that changed a picture
        self.count = 0
        self.begin()

    def begin(self):
        self.kept = Scene(self.kind)
        self.steps = []  # everything that was done to the scene
        self.first = self.kept.draw()

    def fresh(self, steps):
        """The picture of a scene to which all of these was done before it was drawn."""
        scene = Scene(self.kind, self.window)
        for step in steps:
            step(scene)
        picture = scene.draw()
        scene.leave()
        return picture

    def do(self, *steps):
        for step in steps:
            step(self.kept)
            self.steps.append(step)

    def is_like(self, picture):
        """True if the kept scene has this picture, at once or when the view has come to rest.

        Fields may be those of other directions, and steps those of a nearby view, until then.
        """
        for _ in range(DRAWINGS_TO_REST):
            difference = numpy.abs(self.kept.draw().astype(int) - picture).max()
            if difference <= LARGEST_BY_ROUNDING or difference > LARGEST_BEFORE_REST:
                break
        return difference <= LARGEST_BY_ROUNDING

    def expect(self, picture, what):
        """Draws the kept scene, and begins another if the picture is another.

        What a way back leaves behind is none of the mapper's faults.
        """
        if self.is_like(picture):
            if self.kind.searches:
                self.kept.draw()  # images with new voxels one after another begin with known steps
            return True
        if not self.is_like(self.fresh(self.steps)):
            self.faults.append(what)
            print("stale:", what, flush=True)
        self.begin()
        return False

    def try_changes(self, *changes):
        """Makes changes at once, and takes them back."""
        what = " and ".join(map(str, changes))
        self.count += 1
        picture = self.fresh([change.make for change in changes])
        if not numpy.array_equal(picture, self.first):
            self.seen.update((change.target, change.setter) for change in changes[:1])
        self.do(*(change.make for change in changes))
        if self.expect(picture, what):
            self.do(*(change.undo for change in reversed(changes)))
            self.expect(self.first, f"{what}, taken back")


def quick_choice(kind, changes):
    """The changes that the kind is for, and some others, so that all kinds have all of them."""
    focus = KINDS[kind].focus
    first = list(KINDS).index(kind)

    def is_for_kind(change):
        return not change.is_alias and not focus.isdisjoint(
            {change.target, f"{change.target}.{change.setter}"}
        )

    return [
        change
        for i, change in enumerate(changes)
        if is_for_kind(change) or i % len(KINDS) == first
    ]


def each_change(kind, arguments):
    """Tries changes alone, and every third with another."""
    comparison = Comparison(kind)
    changes, _ = changes_of(comparison.kept)
    tried = quick_choice(kind, changes) if arguments.quick else changes
    if arguments.setter:
        tried = [one for one in changes if f"{one.target}.{one.setter}" == arguments.setter]
    dice = random.Random(arguments.seed)
    for i, change in enumerate(tried):
        comparison.try_changes(change)
        if i % 3 == 0:
            comparison.try_changes(change, dice.choice(changes))
    return comparison


def rounds_by_chance(kind, rounds, seed):
    comparison = Comparison(kind)
    changes, _ = changes_of(comparison.kept)
    dice = random.Random(seed)
    for _ in range(rounds):
        comparison.try_changes(*dice.sample(changes, dice.choice((1, 2, 2, 3))))
    return comparison


def setters():
    """Prints how many methods are tried, and fails if one is neither tried nor left out."""
    tried, missing = set(), set()
    for kind in KINDS.values():
        changes, lacking = changes_of(Scene(kind, new_window()))
        tried.update((change.target, change.setter) for change in changes)
        missing.update(lacking)
    by_target = {}
    for target, _ in tried:
        by_target[target] = by_target.get(target, 0) + 1
    print(f"{len(tried)} methods of {len(by_target)} objects are tried:")
    print(", ".join(f"{count} of {target}" for target, count in by_target.items()))
    for reason, names in LEFT_OUT.items():
        print(f"left out ({reason}): {' '.join(names.split())}")
    for name in sorted(missing):
        print(f"{name} is neither tried nor left out: see own.py and left_out.py")
    return not missing


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("kinds", nargs="*", choices=[*KINDS, "setters"], metavar="KIND")
    parser.add_argument("--rounds", type=int)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--setter", help="try this one alone, such as mapper.SetMaskType")
    parser.add_argument("--quick", action="store_true", help="leave most changes to other kinds")
    arguments = parser.parse_args()
    vtkObject.GlobalWarningDisplayOff()  # both pictures may be those of an error
    if arguments.kinds == ["setters"]:
        return setters()
    faults = 0
    for kind in arguments.kinds or KINDS:
        if arguments.rounds:
            comparison = rounds_by_chance(kind, arguments.rounds, arguments.seed)
        else:
            comparison = each_change(kind, arguments)
        faults += len(comparison.faults)
        print(
            f"{kind}: {comparison.count} changes or pairs, {len(comparison.seen)} setters seen in pictures, "
            f"{len(comparison.faults)} stale",
            flush=True,
        )
    return faults == 0


if __name__ == "__main__":
    sys.exit(not main())
