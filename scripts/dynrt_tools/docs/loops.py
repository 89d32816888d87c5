# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Loops in the templates of docs/results/templates.

{{for NAME in A; B; C}} and {{end}}, each in a line of its own, repeat the lines between them for each
value, in which {NAME} stands for the value; in one line they repeat the text between them. With
{{for NAME=TEXT in A=a; B=b}} each turn has two values. The values may go on in the next lines. Loops
may stand in loops."""

import re

from dynrt_tools import project

Lines = list[tuple[int, str]]  # with their numbers in the template
BEGIN = "{{for "
END = "{{end}}"
FOR = r"\{\{for ([\w=]+) in ([^{}]+)\}\}"
BLOCK = re.compile(FOR)
INNERMOST = re.compile(FOR + r"((?:(?!\{\{for ).)*?)\{\{end\}\}")


def repeated(names: str, values: str, text: str) -> list[str]:
    """The text of each turn."""
    turns = []
    for value in values.split(";"):
        turn = text
        for name, one in zip(
            names.split("="), value.strip().split("=", names.count("=")), strict=True
        ):
            turn = turn.replace(f"{{{name}}}", one)
        turns.append(turn)
    return turns


def unrolled_line(line: str) -> str:
    """The line without the loops that begin and end in it."""
    while loop := INNERMOST.search(line):
        line = line[: loop.start()] + "".join(repeated(*loop.groups())) + line[loop.end() :]
    return line


def joined(text: str) -> Lines:
    """The lines of a template; one that begins a loop has all its values."""
    lines: Lines = []
    for number, line in enumerate(text.splitlines(), 1):
        if lines and lines[-1][1].startswith(BEGIN) and "}}" not in lines[-1][1]:
            lines[-1] = (lines[-1][0], f"{lines[-1][1]} {line.strip()}")
        else:
            lines.append((number, line))
    return lines


def unrolled(text: str, where: str) -> Lines:
    """The lines of a template without its loops; `where` names it in messages."""
    open_loops: list[tuple[int, str, str]] = []
    bodies: list[Lines] = [[]]
    for number, line in joined(text):
        try:
            line = unrolled_line(line)
            if loop := BLOCK.fullmatch(line):
                open_loops.append((number, loop[1], loop[2]))
                bodies.append([])
            elif line == END and open_loops:
                _, names, values = open_loops.pop()
                body = bodies.pop()
                for turn in repeated(names, values, "\n".join(text for _, text in body)):
                    bodies[-1] += zip((n for n, _ in body), turn.split("\n"))
            else:
                bodies[-1].append((number, line))
        except ValueError as error:
            raise project.Failed(
                f"{where}:{number}: each turn of a loop has a value for each name"
            ) from error
    if open_loops:
        raise project.Failed(
            f"{where}:{open_loops[-1][0]}: the loop has no end; write {END} in a line"
        )
    return bodies[0]
