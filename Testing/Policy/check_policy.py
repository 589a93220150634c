#!/usr/bin/env python3
"""Rules of the tree that no compiler checks. Each rule is a function that returns the violations.

Usage: check_policy.py RULE. Checks the files that git tracks. Exit code 77: not a git tree.
"""

import collections
import pathlib
import posixpath
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
SKIPPED = 77

TOP_LEVEL = set(
    """.ci .clang-format .clang-tidy .gitattributes .github .gitignore App CHANGELOG.md
    CMakeLists.txt CMakePresets.json CONTRIBUTING.md Data Documentation LICENSE README.md
    SECURITY.md Testing VolumeModule demo.sh test.sh""".split()
)
LARGEST_FILE_BYTES = 1_000_000
LONGEST_FILE_LINES = 700
LONGEST_FUNCTION_LINES = 60
MOST_LEVELS_OF_CONTROL_FLOW = 3
# Statements of today that are nested deeper. The number may only fall.
MOST_DEEPER_STATEMENTS = 35
LONGEST_HEADER_OF_ONE_FILE = 79
# Headers of today that belong into the one file that includes them. The number may only fall.
MOST_SMALL_HEADERS_OF_ONE_FILE = 39
LONGEST_SUBJECT = 72
MOST_FILES_WITHOUT_BODY = 5
CODE = {".h", ".cxx", ".in", ".glsl", ".py", ".sh", ".cmake"}

# A comment that begins with one of these leaves its subject to the code or another comment.
NO_SUBJECT = {"of", "what", "whose", "nor", "none", "those"}


def git(*arguments):
    """The output of a git command on this tree. Without a git tree the rule is skipped."""
    command = ["git", "-c", "safe.directory=*", "-C", str(ROOT), *arguments]
    answer = subprocess.run(command, capture_output=True, check=False)
    if answer.returncode:
        print(f"Skipped: {ROOT} is not a git tree: {answer.stderr.decode().strip()}")
        sys.exit(SKIPPED)
    return answer.stdout.decode(errors="replace")


def tracked(folder="", suffixes=None):
    """Tracked paths below folder that exist, relative to the root."""
    names = git("ls-files", "-z").split("\0")
    paths = [pathlib.PurePosixPath(name) for name in names if name]
    return [
        path
        for path in paths
        if str(path).startswith(folder)
        and (suffixes is None or path.suffix in suffixes)
        and (ROOT / path).is_file()
    ]


def text_of(path):
    """Text of a file; empty for binary and missing files."""
    content = (ROOT / path).read_bytes() if (ROOT / path).is_file() else b""
    return "" if b"\0" in content else content.decode("utf-8", errors="replace")


def lines_matching(paths, pattern, advice):
    """One message for each line of the paths that matches the pattern."""
    found = re.compile(pattern)
    return [
        f"{path}:{number}: {line.strip()[:80]}\n    {advice}"
        for path in paths
        for number, line in enumerate(text_of(path).splitlines(), 1)
        if found.search(line)
    ]


def top_level_is_agreed():
    strangers = {path.parts[0] for path in tracked()} - TOP_LEVEL
    return [
        f"{name}: not one of the agreed top-level entries; move it into VolumeModule, App, "
        "Testing, Data or Documentation"
        for name in sorted(strangers)
    ]


def quoted_paths_exist():
    """A path in a document starts with a top-level folder, is a link, or names a source file.

    NAME stands for any name, as in VolumeModule/Shaders/Blend/NAME.glsl.
    """
    problems = []
    files = {str(path) for path in tracked()}
    for document in tracked(suffixes={".md"}):
        text = text_of(document)
        below_root = re.findall(
            r"(?<![\w/.])(?:\./)?((?:VolumeModule|App|Testing|Data|Documentation|\.ci)/[\w./*-]*)",
            text,
        )
        sources = re.findall(r"`([\w./-]+\.(?:h|cxx|glsl|md|py|sh))`", text)
        links = re.findall(r"\]\((?!\w+:|#)([^)#]+)", text)
        missing = [path for path in below_root if not names_a_file(path, files)]
        missing += [path for path in sources if not ends_a_path(path, files)]
        missing += [path for path in links if not (ROOT / document.parent / path).exists()]
        problems += [
            f"{document}: {path} does not exist; correct the document, or add the file"
            for path in dict.fromkeys(missing)
        ]
    return problems


def names_a_file(path, files):
    pattern = path.rstrip("./").replace("NAME", "*")
    return (ROOT / pattern).exists() or any(
        pathlib.PurePosixPath(file).match(pattern) for file in files
    )


def ends_a_path(path, files):
    pattern = path.removeprefix("./").replace("NAME", "*")
    return any(pathlib.PurePosixPath(file).match(pattern) for file in files)


def cmake_example_is_tested():
    example = "Documentation/Examples/Window/CMakeLists.txt"
    document = "Documentation/Installing.md"
    text = text_of(example).strip()
    if text and text in text_of(document):
        return []
    return [f"{document}: its CMake example is not {example}, which is tested; copy that file in"]


def files_are_short():
    exempt = headers_of_vtk_classes()
    problems = []
    for path in tracked():
        if path.suffix not in CODE and path.name != "CMakeLists.txt" or path in exempt:
            continue
        lines = text_of(path).splitlines()
        if len(lines) > LONGEST_FILE_LINES and not is_table(lines):
            problems.append(
                f"{path}: {len(lines)} lines, {LONGEST_FILE_LINES} are allowed; split it by idea"
            )
    return problems


def headers_of_vtk_classes():
    """Headers of the classes that VTK's macros install and wrap."""
    found = re.compile(r"(?i)\bclasses\s+((?:vtk\w+\s*)+)")
    return {
        path.parent / f"{name}.h"
        for path in tracked()
        if path.name == "CMakeLists.txt"
        for names in found.findall(text_of(path))
        for name in names.split()
    }


def is_table(lines):
    """True if most lines are rows: values in braces, or strings."""
    return 2 * sum(line.lstrip().startswith(("{", '"')) for line in lines) > len(lines)


def functions_are_short():
    """Counts the lines between braces in column 0, where clang-format puts those of functions."""
    problems = []
    for path in tracked(suffixes={".h", ".cxx"}):
        lines = text_of(path).splitlines()
        start = None
        for number, line in enumerate(lines):
            if line == "{":
                start = number
            elif line == "}" and start is not None:
                first, body = first_line_before(lines, start), lines[start + 1 : number]
                if len(body) > LONGEST_FUNCTION_LINES and not (
                    opens_namespace(first) or is_table(body)
                ):
                    problems.append(
                        f"{path}:{start}: {first}: {len(body)} lines, {LONGEST_FUNCTION_LINES} are "
                        f"allowed; split it by idea"
                    )
                start = None
            elif line == "};":
                start = None
    return problems


def first_line_before(lines, brace):
    """First line of the declaration that the brace opens; it follows an empty line or a closing brace."""
    first = brace - 1
    while first > 0 and lines[first - 1] and not re.match(r"[{}#/]|.*;$", lines[first - 1]):
        first -= 1
    return lines[first]


def opens_namespace(first_line):
    return re.match(r'namespace\b|extern "C"', first_line)


def control_flow_is_shallow():
    problems = [
        f"{path}:{number}: {word} is nested {level} levels deep, {MOST_LEVELS_OF_CONTROL_FLOW} are "
        "allowed; give the inner levels a function of their own"
        for path in tracked(suffixes={".h", ".cxx", ".glsl"})
        for number, level, word in ControlFlow(text_of(path)).statements
        if level > MOST_LEVELS_OF_CONTROL_FLOW
    ]
    return ratchet(problems, "MOST_DEEPER_STATEMENTS")


def ratchet(problems, limit):
    """The problems if they are more than the exceptions that are left from before the rule."""
    most = globals()[limit]
    if len(problems) > most:
        return problems + [f"{len(problems)} in all, {most} are allowed by {limit}"]
    advice = f"; lower {limit} to it" if len(problems) < most else ""
    print(f"Exceptions that are left: {len(problems)}{advice}")
    return []


class ControlFlow:
    """Lines, levels and keywords of the statements of a text; "else if" has the level of its if."""

    def __init__(self, text):
        words = r"\b(?:if|for|while|do|switch|else)\b|[{}();]"
        self.code = without_comments_and_strings(text)
        self.tokens = [*re.finditer(words, self.code), *re.finditer("$", self.code)]
        self.next = 0
        self.statements = []
        self.read_until("", 0)

    def take(self, *words):
        """Steps over the next token if it is one of the words, and returns it then."""
        token = self.tokens[self.next]
        if token.group() not in words:
            return None
        self.next += 1
        return token

    def read_statement(self, level):
        """Reads a statement that stands in as many levels of others."""
        if control := self.take("if", "for", "while", "do", "switch"):
            self.read_control(control, level + 1)
        elif self.take("{"):
            self.read_until("}", level)
        elif self.take("("):
            self.read_until(")", level)
            if self.tokens[self.next].group() not in (")", "}", ""):
                self.read_statement(level)
        else:
            self.next += 1

    def read_until(self, end, level):
        while not self.take(end):
            self.read_statement(level)

    def read_control(self, control, level):
        line = self.code.count("\n", 0, control.start()) + 1
        self.statements.append((line, level, control.group()))
        if self.take("("):
            self.read_until(")", level)
        self.read_statement(level)
        if control.group() == "do":
            self.take("while")
        self.take(";")
        if control.group() == "if" and self.take("else"):
            is_chain = self.tokens[self.next].group() == "if"
            self.read_statement(level - is_chain)


def without_comments_and_strings(text):
    """The text with the same lines, without comments, the contents of strings, and directives."""
    comment = r"/\*.*?\*/|//[^\n]*"
    string = r'R"\w*\(.*?\)\w*"|"(?:[^"\\\n]|\\.)*"'
    letter = r"'(?:[^'\\\n]|\\.)'"
    directive = r"(?m:^)[ \t]*#(?:\\\n|[^\n])*"
    return re.sub(
        f"{comment}|{string}|{letter}|{directive}",
        lambda found: "\n" * found.group().count("\n"),
        text,
        flags=re.S,
    )


def small_headers_serve_several_files():
    """A small header that one file includes, besides its own source, only cuts an idea in two."""
    includers = collections.defaultdict(set)
    files = {str(path) for path in tracked()}
    for path in tracked(suffixes={".h", ".cxx", ".in"}):
        for name in re.findall(r'#\s*include\s*[<"]([^">]+)[">]', text_of(path)):
            for header in included_files(path, name, files):
                includers[header].add(str(path))
    exempt = headers_of_vtk_classes()
    problems = []
    for path in tracked(suffixes={".h"}):
        others = includers[str(path)] - {str(path.with_suffix(".cxx"))}
        length = len(text_of(path).splitlines())
        if len(others) == 1 and length <= LONGEST_HEADER_OF_ONE_FILE and path not in exempt:
            problems.append(
                f"{path}: {length} lines that only {others.pop()} includes; move what it declares "
                "there, with its source"
            )
    return ratchet(problems, "MOST_SMALL_HEADERS_OF_ONE_FILE")


def included_files(path, name, files):
    """The tracked files that an include directive can mean: beside the file, or below a root."""
    for folder in (path.parent, "VolumeModule", "App", "."):
        candidate = posixpath.normpath(posixpath.join(folder, name))
        if candidate in files:
            return [candidate]
    return [file for file in files if file.endswith("/" + name)]


def files_are_small():
    return [
        f"{path}: {(ROOT / path).stat().st_size} bytes, {LARGEST_FILE_BYTES} are allowed; make it "
        "when it is needed, or take it from a Debian package"
        for path in tracked()
        if (ROOT / path).stat().st_size > LARGEST_FILE_BYTES
    ]


def shaders_have_no_switches():
    return lines_matching(
        tracked("VolumeModule/Shaders/", {".glsl"}),
        r"^\s*#\s*(if|ifdef|ifndef|elif|else)\b",
        "a choice is a file in its slot's folder, 'off' too; write one instead of a switch",
    )


# Files that only shaders have, because packets leave their scenes to them.
LEFT_TO_SHADERS = set(
    """Blend/ComponentAdditive Blend/ComponentAverage Blend/ComponentExtreme
    Gradient/ClippedDifferences Gradient/Stored March/FirstHit March/MaterialFromBehind
    March/MidpointFromBehind March/PublishedSum March/RangeMean March/Simpson March/Slice
    March/VoxelSurfaces Material/TwoValues Probe/FetchCount Sample/Texel Step/CellField
    Step/VariationField Values/Two""".split()
)


def shader_files_have_twins():
    """Packets repeat each file of a slot, or its scenes are left to shaders."""
    capability = text_of("VolumeModule/March/Processor/PacketMarcher.cxx")

    def names_in(variable):
        return set(re.findall(r'"(\w+)"', re.search(variable + r" = \{([^}]*)\}", capability)[1]))

    without_work = names_in("nothing")
    slots_of_device = names_in("slotsOfDevice") | {"Marched", "Math"}
    folder = pathlib.PurePath("VolumeModule/Shaders")
    files = {
        path.relative_to(folder).with_suffix("").as_posix()
        for path in tracked(str(folder), {".glsl"})
        if len(path.relative_to(folder).parts) == 2
    }
    twins = {
        twin
        for path in tracked("VolumeModule/Core/Packets", {".h"})
        for comment in re.findall(r"// Twin of ([^#]*)", text_of(path))
        for twin in re.findall(r"(\w+/\w+)\.glsl", comment)
    }
    needing = {
        file
        for file in files - LEFT_TO_SHADERS
        if file.split("/")[0] not in slots_of_device
        and file.split("/")[1] not in without_work
    }
    return [
        f"VolumeModule/Shaders/{file}.glsl: no header of Core/Packets is its twin; write one, or "
        "list it in LEFT_TO_SHADERS"
        for file in sorted(needing - twins)
    ] + [
        f"{file}: named as a twin or as left to shaders, but not a file of a slot"
        for file in sorted((twins | LEFT_TO_SHADERS) - files)
    ]


def no_glsl_in_strings():
    words = r"\b(vec[234]|[iu]vec[234]|mat[34]|sampler[123]D|gl_[A-Z]\w+|void main)\b|\btexture\("
    words += r"|\buniform\s+(float|int|uint|bool)\b"
    problems = []
    for path in tracked("VolumeModule/", {".h", ".cxx"}) + tracked("App/", {".h", ".cxx"}):
        code = re.sub(r"/\*.*?\*/|//[^\n]*", "", text_of(path), flags=re.S)
        strings = re.findall(r'R"\w*\((.*?)\)\w*"|"((?:[^"\\\n]|\\.)*)"', code, flags=re.S)
        problems += [
            f'{path}: "{(raw or plain).strip()[:60]}" looks like GLSL; put it into a .glsl file '
            "below VolumeModule/Shaders"
            for raw, plain in strings
            if re.search(words, raw or plain)
        ]
    return problems


def no_machine_paths():
    checked = [path for path in tracked() if path.name != pathlib.Path(__file__).name]
    folders = r"(?<![\w.}/-])/(home|Users|root|work|scratch|mnt|media)/\w"
    sources = r"\w://[\w.-]*(registry|artifact|mirror|proxy|snapshot)|^\s*deb\s+(\[.*\]\s+)?\w+://"
    return lines_matching(
        checked, folders, "a path of one machine; make it relative, or take it from a variable"
    ) + lines_matching(
        checked, sources, "a package source of one machine; leave it to the machine's settings"
    )


def core_stands_alone():
    return lines_matching(
        tracked("VolumeModule/Core/", {".h", ".cxx"}),
        r'#\s*include\s*[<"](vtk|Q[A-Z]|GL/|GLES|EGL/|X11/)',
        "Core is mathematics without VTK, GL and Qt; what needs them belongs to VolumeModule",
    )


def public_headers_need_no_core():
    headers = sorted(headers_of_vtk_classes())
    return lines_matching(
        headers,
        r'#\s*include\s*[<"](Core/|glm/|tbb/|oneapi/)',
        "an installed header must do without Core; hide the member behind a std::unique_ptr",
    )


def comments_name_their_subject():
    """A comment begins with its subject, and one behind code does not go on in the next line's."""
    problems = []
    for path in tracked(suffixes={".h", ".cxx", ".glsl"}):
        for number, comment, is_behind_code in comments_of(path):
            first_word = re.match(r"\W*(\w*)", comment).group(1).lower()
            advice = ""
            if first_word in NO_SUBJECT:
                advice = f'begins with "{first_word}"; begin with a noun or a sentence instead'
            elif is_behind_code and comment.endswith(","):
                advice = "goes on in the next line; write one that can be read alone"
            if advice:
                problems.append(f"{path}:{number}: {comment[:80]}\n    The comment {advice}.")
    return problems


def comments_of(path):
    """The line number and the first line of each comment, and whether it stands behind code."""
    text = re.sub(r'"(\\.|[^"\\\n])*"', '""', text_of(path))
    block, whole_lines, behind_code = r"/\*[\s\S]*?\*/", r"(?m:^)(?:[ \t]*//.*\n)+", r"//.*"
    for comment in re.finditer(f"{block}|{whole_lines}|{behind_code}", text):
        number = text.count("\n", 0, comment.start()) + 1
        first_line = comment.group().strip("/*!< \t\n").partition("\n")[0].rstrip()
        code = text[: comment.start()].rpartition("\n")[2]
        yield number, first_line, code.strip() != ""


def commits_say_why():
    """Checks the commits that are newer than the one that introduced this rule."""
    rule = ("-S", "def commits_say_why", "--", "Testing/Policy/check_policy.py")
    oldest_first = git("log", "--reverse", "--format=%H", *rule).split()
    if not oldest_first:
        return []
    commits = git(
        "log", "--no-merges", "--name-only", "--format=%x01%h%x00%s%x00%b%x00", f"{oldest_first[0]}.."
    )
    return [problem for commit in commits.split("\x01")[1:] for problem in commit_problems(commit)]


def commit_problems(commit):
    name, subject, body, files = commit.split("\0")
    problems = []
    if len(subject) > LONGEST_SUBJECT:
        problems.append(
            f"{name}: {subject}\n    {len(subject)} characters in the subject, {LONGEST_SUBJECT} "
            "are allowed; name one idea, and move the rest into the body"
        )
    changed = len([line for line in files.splitlines() if line])
    if changed > MOST_FILES_WITHOUT_BODY and not body.strip():
        problems.append(
            f"{name}: {subject}\n    {changed} files change without a body; say why in one"
        )
    return problems


def type_names_are_unique():
    """Two types of one name in one program would be undefined behaviour that no linker reports."""
    problems, places = [], {}
    for path in tracked(suffixes={".h", ".cxx"}):
        for name in types_defined_in(text_of(path)):
            if name in places:
                problems.append(f"{path}: {name} is also a type of {places[name]}; rename one")
            places[name] = path
    return problems


def types_defined_in(text):
    """The qualified names of the types that a file defines outside of unnamed namespaces."""
    code = without_comments_and_strings(text)
    keyword = r"\b(?P<keyword>namespace|class|struct|union|enum(?: class)?)"
    name = r"(?:[A-Z]+_EXPORT\s+)?(?P<name>[\w:]+)?"
    bases = r"[^;{}()=<>]*(?:<[^;{}()]*)?"
    scopes, types = [], []
    for found in re.finditer(rf"(?:{keyword}\s+{name}{bases})?(?P<brace>[{{}}])", code):
        if found["brace"] == "}":
            scopes.pop()
            continue
        # No name: an unnamed namespace or type, or the brace of a function or a value.
        scopes.append(found["name"])
        if found["keyword"] != "namespace" and None not in scopes:
            types.append("::".join(scopes))
    return types


def main():
    rules = {name: rule for name, rule in globals().items() if name in sys.argv[1:]}
    if len(rules) != 1 or len(sys.argv) != 2:
        print(__doc__)
        return 2
    problems = next(iter(rules.values()))()
    print("\n".join(problems) or "Nothing breaks this rule.")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
