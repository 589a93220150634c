#!/usr/bin/env python3
"""Uses the viewer as a screen reader does: through AT-SPI, by names, roles and actions.

Usage: test_screen_reader.py VARIMARCH_VIEWER CASE
Starts the viewer on a display and a session bus of its own. Exit code 77, with a sentence, where a
package is missing.
"""

import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time

SKIPPED = 77
MOST_SECONDS = 100
MOST_SECONDS_IN_ALL = 270  # CTest ends the test soon after, and would leave the display behind
INNER = "VARIMARCH_SCREEN_READER"


def missing_package():
    """The Debian package that this test lacks, if any."""
    needed = {
        "dbus-run-session": "dbus",
        "xauth": "xauth",
        "xvfb-run": "xvfb",
        "/usr/libexec/at-spi-bus-launcher": "at-spi2-core",
    }
    for program, package in needed.items():
        if not shutil.which(program):
            return package
    try:
        import pyatspi  # noqa: F401
    except ImportError:
        return "python3-pyatspi"
    return None


def children(accessible):
    """The parts of an accessible: none if it has gone meanwhile."""
    count = max(accessible.get_child_count(), 0)
    return [child for child in (accessible.getChildAtIndex(i) for i in range(count)) if child]


def descendants(accessible):
    for child in children(accessible):
        yield child
        yield from descendants(child)


def has(accessible, *states):
    found = accessible.getState()
    return all(found.contains(state) for state in states)


def ask(condition):
    """The result of a condition, or None if an accessible that it asks has gone meanwhile."""
    from gi.repository import GLib

    try:
        return condition()
    except GLib.GError:
        return None


def wait_for(condition, what):
    end = time.monotonic() + MOST_SECONDS
    while time.monotonic() < end:
        found = ask(condition)
        if found:
            return found
        time.sleep(0.2)
    raise AssertionError(f"this never happened: {what}")


def do(accessible, name):
    actions = accessible.queryAction()
    names = [actions.getName(i) for i in range(actions.nActions)]
    assert name in names, f"{accessible} has the actions {names}, not {name}"
    actions.doAction(names.index(name))


class Viewer:
    """The program, as AT-SPI tells of it."""

    def __init__(self, program):
        environment = dict(os.environ, QT_LINUX_ACCESSIBILITY_ALWAYS_ON="1", QT_QPA_PLATFORM="xcb")
        self.process = subprocess.Popen([program], env=environment)

    def open_phantom(self):
        self.application = wait_for(self._application, "the viewer appears on the bus")
        self.do("push button", "I understand", "Press")
        self.do("push button", "Phantom of a torso", "Press")
        wait_for(lambda: self.find("label", "Slab", shown=True), "the phantom is opened")

    def _application(self):
        import pyatspi

        for application in children(pyatspi.Registry.getDesktop(0)):
            if application.name == "varimarch-viewer" and children(application):
                return application
        return None

    def find(self, role, name, shown=False):
        """The first accessible with a role and a name, if any."""
        import pyatspi

        states = [pyatspi.STATE_SHOWING] if shown else []
        for accessible in descendants(self.application):
            if accessible.getRoleName() == role and accessible.name == name and has(accessible, *states):
                return accessible
        return None

    def await_one(self, role, name):
        return wait_for(lambda: self.find(role, name, shown=True), f"a {role} named {name!r} is shown")

    def do(self, role, name, action):
        do(self.await_one(role, name), action)

    def end(self):
        self.process.terminate()
        self.process.wait(timeout=MOST_SECONDS)


# Roles that tell a user nothing about a control that takes keys.
EMPTY_ROLES = {"filler", "unknown", "invalid", "panel", "redundant object", "frame"}


def faults(viewer):
    """The faults of the controls on the screen that take keys, and the number of these controls."""
    import pyatspi

    found, count = [], 0
    for control in descendants(viewer.application):
        if has(control, pyatspi.STATE_FOCUSABLE, pyatspi.STATE_SHOWING, pyatspi.STATE_ENABLED):
            count += 1
            role = control.getRoleName()
            place = f"{role} {control.name!r} in {control.parent.getRoleName()} {control.parent.name!r}"
            if not control.name:
                found.append(f"no name: {place}")
            if role in EMPTY_ROLES:
                found.append(f"a role that says nothing: {place}")
            labels = [r for r in control.getRelationSet() if r.getRelationType() == pyatspi.RELATION_LABELLED_BY]
            if role == "combo box" and not labels and not control.description:
                found.append(f"only its choice for a name: {place}")
    return found, count


def tabs_of_panels(viewer):
    import pyatspi

    return {tab.name for tab in descendants(viewer.application) if tab.getRole() == pyatspi.ROLE_PAGE_TAB}


def every_control_has_a_name_and_a_role(viewer):
    tabs = wait_for(lambda: tabs_of_panels(viewer), "there are panels")
    assert len(tabs) == 7, f"there are the panels {tabs}"
    wrong = set()
    for tab in tabs:
        viewer.do("page tab", tab, "Press")
        time.sleep(0.5)
        found, count = wait_for(lambda: faults(viewer), f"the controls with the panel {tab} stay")
        assert count > 30, f"only {count} controls with the panel {tab}"
        wrong.update(found)
    assert not wrong, "\n".join(sorted(wrong))


def undo_steps(viewer):
    return [
        item.name
        for item in descendants(viewer.application)
        if item.getRoleName() == "menu item" and item.name.startswith("Undo")
    ]


def a_preset_is_chosen(viewer):
    viewer.do("page tab", "Presets", "Press")
    gallery = viewer.await_one("list", "Presets")
    do(next(item for item in children(gallery) if item.name == "CT lungs"), "Toggle")
    wait_for(lambda: "Undo choose CT lungs" in undo_steps(viewer), "the look is chosen")
    viewer.do("page tab", "Look", "Press")
    viewer.await_one("combo box", "CT lungs")


def a_tool_is_chosen(viewer):
    import pyatspi

    viewer.do("check box", "Distance", "Toggle")
    wait_for(
        lambda: has(viewer.find("check box", "Distance"), pyatspi.STATE_CHECKED)
        and not has(viewer.find("check box", "Rotate"), pyatspi.STATE_CHECKED),
        "Distance is the tool instead of Rotate",
    )


def a_number_is_set(viewer):
    viewer.await_one("spin button", "Thickness of the slices").queryValue().currentValue = 12.5
    wait_for(lambda: "Undo slab" in undo_steps(viewer), "the slices are thicker")
    value = viewer.find("spin button", "Thickness of the slices").queryValue().currentValue
    assert value == 12.5, f"the slices are {value} mm thick"


def run_inside(program, case):
    """Runs this script on a display, a session bus and in a home of its own, and leaves nothing."""
    command = ["xvfb-run", "--auto-servernum", "--server-args", "-screen 0 1280x800x24 -noreset"]
    command += ["dbus-run-session", "--", sys.executable, "-B", __file__, program, case]
    with tempfile.TemporaryDirectory() as folder:
        environment = dict(os.environ, **{INNER: "1"})
        for name in ("HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME", "XDG_RUNTIME_DIR"):
            environment[name] = folder
        process = subprocess.Popen(command, env=environment, start_new_session=True)
        try:
            return process.wait(timeout=MOST_SECONDS_IN_ALL)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGTERM)
            raise


def main():
    program, case = sys.argv[1:]
    package = missing_package()
    if package:
        print(f"skipped: the package {package} is missing")
        return SKIPPED
    if INNER not in os.environ:
        return run_inside(str(pathlib.Path(program).resolve()), case)
    viewer = Viewer(program)
    try:
        viewer.open_phantom()
        globals()[case](viewer)
    finally:
        viewer.end()
    return 0


if __name__ == "__main__":
    sys.exit(main())
