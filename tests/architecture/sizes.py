#!/usr/bin/python3
"""What a reader can hold in mind: sizes of folders, files, functions and types of engine/ and game/.

Reads C++ by its braces, which is enough for code in one format (architecture.format) and without macros that open or
close scopes. Plain data, a type without functions, may have as many fields as DATA_FIELDS.
"""

import collections
import dataclasses
import pathlib
import re
import statistics
import sys

from sources import ROOT, finish, own_files

FOLDER = 25  # sources beside each other
FILE = 400  # lines
FUNCTION = 60  # lines, from the first of its signature to its closing brace
MEDIAN, P90 = 7, 25  # lines, of all functions
PUBLIC_FUNCTIONS = 25  # of a type; what the language makes by itself (constructors, assignment) is not counted
FIELDS = 20  # of a type that has functions
DATA_FIELDS = 40  # of one that has none

# What may still be larger: folders, files, types and functions by their names. An entry that is not needed any more
# fails, so that it goes.
EXEMPT = {"ContactConstraint", "Simulation"}

TEXT = re.compile(r"""
      //[^\n]*                                          # comments
    | /\*.*?\*/
    | R"(?P<mark>[^()\s]*)\(.*?\)(?P=mark)"             # raw text
    | "(?:\\.|[^"\\\n])*"                               # text
    | (?<![0-9a-fA-F])'(?:\\.|[^'\\\n])+'               # a letter, not the mark between digits
    | ^[ \t]*\#(?:[^\n\\]|\\.|\\\n)*                    # what is the preprocessor's
""", re.VERBOSE | re.DOTALL | re.MULTILINE)
TEMPLATE = re.compile(r"\btemplate\s*<(?:[^<>]|<[^<>]*>)*>")
TYPE = re.compile(r"\b(class|struct|union)\b(?:\s+(?:alignas\s*\([^)]*\)|\[\[[^\]]*\]\]))*\s+([\w:]+)")
ACCESS = re.compile(r"^\s*((?:public|protected|private)\s*:(?!:)\s*)+")
NO_FIELD = re.compile(r"^\s*(?:using|typedef|friend|static|template|enum|class|struct|union|static_assert)\b")
INITIALISED = re.compile(r"\)[^)]*:(?!:).*[\w>]\s*$", re.DOTALL)  # "Name(...) : member" before a brace


@dataclasses.dataclass
class Type:
    """A class or struct: where it is, what it holds."""
    name: str
    line: int
    public: bool
    behaves: bool = False  # has functions, public or not
    functions: int = 0
    fields: int = 0


@dataclasses.dataclass
class Function:
    name: str
    line: int
    lines: int


def blanked(text):
    """The code alone: comments, texts and directives as spaces, every line where it was."""
    return TEXT.sub(lambda found: re.sub(r"[^\n]", " ", found.group(0)), text)


def bare(head):
    """A declaration without templates, attributes and what stands in parentheses or angle brackets."""
    head = re.sub(r"\[\[.*?\]\]", " ", TEMPLATE.sub(" ", head), flags=re.DOTALL)
    for brackets in (r"\([^()]*\)", r"(?<![<\-=])<[^<>()=;]*>"):
        mark = "()" if brackets.startswith(r"\(") else ""
        before = None
        while before != head:
            before = head
            head = re.sub(brackets, f"\0{mark}\0" if mark else "", head).replace("\0()\0", "\1")
    return head.replace("\1", "()")


def kind_of(head, within):
    """What a brace after `head` opens: 'namespace', 'type', 'function' or '' for all else."""
    if within == "function":
        return ""
    if re.search(r"\bnamespace\b", head) or re.search(r'\bextern\s*$', head):
        return "namespace"
    plain = bare(head)
    if re.search(r"\benum\b", plain):
        return ""
    if TYPE.search(plain) and "(" not in TYPE.sub(" ", plain):
        return "type"
    if "()" in plain and (not re.search(r"(?<![=!<>])=(?!=)", plain) or "operator" in plain):
        return "function"
    return ""


def name_of(path):
    return pathlib.PurePosixPath(path).name


def line_of(text, at):
    return text.count("\n", 0, at) + 1


def note_member(owner, declaration):
    """Counts what a declaration in a type's body declares."""
    plain = bare(declaration).strip()
    if not plain or NO_FIELD.match(plain) and "()" not in plain:
        return
    before = re.split(r"(?<![=!<>])=(?!=)", plain)[0] if "operator" not in plain else plain
    if "()" in before:
        name = re.search(r"([~\w]+)\s*\(\)|operator", before)
        by_itself = not name or name.group(0).startswith(("~", "operator")) or name.group(1) == owner.name
        is_member = not by_itself and not plain.startswith("friend")
        owner.behaves |= is_member
        owner.functions += owner.public and is_member
    elif not NO_FIELD.match(plain):
        owner.fields += 1 + re.sub(r"\{[^{}]*\}", "", plain).count(",")


def read(text):
    """The types and functions of a file."""
    code = blanked(text)
    types, functions = [], []
    stack = [("namespace", None, 0)]  # kind, type or function, where its head begins
    begin = at = 0

    def start(head_begin):
        rest = code[head_begin:]
        return head_begin + len(rest) - len(rest.lstrip())

    while at < len(code):
        letter = code[at]
        kind, owner, _ = stack[-1]
        if letter == "(" and kind != "":  # nothing in parentheses opens a scope that counts
            depth = 0
            while at < len(code):
                depth += {"(": 1, ")": -1}.get(code[at], 0)
                if depth == 0:
                    break
                at += 1
        elif letter == ":" and kind == "type" and ACCESS.match(code[begin:at + 1]) and code[at + 1:at + 2] != ":":
            owner.public = "public" in code[begin:at]
            begin = at + 1
        elif letter == ";":
            if kind == "type":
                note_member(owner, code[begin:at])
            begin = at + 1
        elif letter == "{":
            head = code[begin:at]
            opens = kind_of(head, kind if kind != "" else "function")
            if opens == "function" and INITIALISED.search(bare(head)):
                opens = ""
            if opens == "type":
                found = TYPE.search(bare(head))
                line = line_of(code, start(begin))
                owner = Type(found.group(2), line, found.group(1) != "class")
                types.append(owner)
                stack.append(("type", owner, begin))
            elif opens == "function":
                if kind == "type":
                    note_member(owner, head)
                stack.append(("function", bare(head).split("()")[0].split()[-1], start(begin)))
            elif opens == "namespace":
                stack.append(("namespace", None, begin))
            else:
                stack.append(("", None, begin))
            if opens:
                begin = at + 1
        elif letter == "}":
            kind, owner, head_begin = stack.pop() if len(stack) > 1 else stack[0]
            if kind == "function":
                first = line_of(code, head_begin)
                functions.append(Function(owner, first, line_of(code, at) - first + 1))
            if kind:
                begin = at + 1
        at += 1
    return types, functions


def problems_of_file(path, text, functions):
    """(what could be exempt, the problem) for every rule that one file breaks; adds its functions."""
    length = text.count("\n")
    if length > FILE:
        yield name_of(path), f"{path}:1: {length} lines; at most {FILE}"
    types, own_functions = read(text)
    functions += own_functions
    for function in own_functions:
        if function.lines > FUNCTION:
            yield function.name, (f"{path}:{function.line}: {function.name} has {function.lines} lines; "
                                  f"at most {FUNCTION}")
    for kind in types:
        if kind.functions > PUBLIC_FUNCTIONS:
            yield kind.name, (f"{path}:{kind.line}: {kind.name} has {kind.functions} public functions; "
                              f"at most {PUBLIC_FUNCTIONS}")
        most = FIELDS if kind.behaves else DATA_FIELDS
        if kind.fields > most:
            yield kind.name, f"{path}:{kind.line}: {kind.name} has {kind.fields} fields; at most {most}"


def check(root, exempt):
    """Every problem in the tree at `root`, and the sizes in words."""
    files = own_files(root, "engine", "game", "tests", suffixes=(".h", ".cpp"))
    found, functions = [], []
    folders = collections.Counter(str(pathlib.PurePosixPath(path).parent) for path in files)
    for folder, count in sorted(folders.items()):
        if count > FOLDER:
            found.append((folder, f"{folder}: {count} sources; at most {FOLDER}"))
    for path in files:
        text = (root / path).read_text(encoding="utf-8")
        if path.startswith("tests/"):  # a test is a list of cases: only how long its files are
            found += [(name_of(path), f"{path}:1: {text.count(chr(10))} lines; at most {FILE}")] * (text.count("\n") > FILE)
        else:
            found += problems_of_file(path, text, functions)
    problems = [problem for name, problem in found if name not in exempt]
    problems += [f"tests/architecture/sizes.py: {name} is no longer too large: strike it off EXEMPT"
                 for name in sorted(exempt - {name for name, _ in found})]
    lengths = sorted(function.lines for function in functions) or [0]
    median, p90 = statistics.median(lengths), lengths[int(0.9 * (len(lengths) - 1))]
    if median > MEDIAN or p90 > P90:
        problems.append(f"functions have {median:g} lines in the median and {p90} at the 90th percentile; "
                        f"at most {MEDIAN} and {P90}")
    return problems, f"{len(files)} files, {len(lengths)} functions of {median:g} and {p90} lines (median, p90)"


if __name__ == "__main__":
    checked_root = pathlib.Path(sys.argv[1]).resolve() if len(sys.argv) > 1 else ROOT
    finish(*check(checked_root, EXEMPT))
