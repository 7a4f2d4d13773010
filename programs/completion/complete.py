#!/usr/bin/env python3
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Completion for a shell, from what a command says with --help: complete.py bash|zsh PROGRAM.

    python3 programs/completion/complete.py bash build/bin/hgrid > programs/completion/hgrid.bash
    python3 programs/completion/complete.py zsh build/bin/hgrid > programs/completion/_hgrid

and the same for hgrid-mpi. The tests completion.* repeat this and compare.
"""

import pathlib
import sys

import command_help

BASH = """\
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Completion of {program} for bash, made by programs/completion/complete.py; bash finds it by its name once installed.
# shellcheck shell=bash

{function}() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD - 1]}} command='' word
  local options='' values='' head=''
  # bash splits --law=mono into three words.
  if [[ $current == = ]]; then
    current=''
  elif [[ $previous == = ]]; then
    previous=${{COMP_WORDS[COMP_CWORD - 2]}}
  fi
  for word in "${{COMP_WORDS[@]:1:COMP_CWORD-1}}"; do
    [[ $word == -* ]] || {{ command=$word && break; }}
  done
  case $command in
{options}
  esac
  case "$command $previous" in
{values}
  esac
  COMPREPLY=()
  if [[ -n $values && $current != -* ]]; then
    # Of lists the word behind the last comma.
    [[ $current != *,* ]] || head=${{current%,*}},
    mapfile -t COMPREPLY < <(compgen -P "$head" -W "$values" -- "${{current##*,}}")
  elif [[ $current == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$options" -- "$current")
  fi
}}
# Everything else is a file.
complete -o bashdefault -o default -F {function} {program}
"""

ZSH = """\
#compdef {program}
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Completion of {program} for zsh, made by programs/completion/complete.py.

{function}() {{
  local curcontext=$curcontext state line
  typeset -A opt_args
  _arguments -C \\
{own} \\
    '1:command:->command' '*::argument:->argument'
  case $state in
    command)
      local -a commands=(
{commands}
      )
      _describe command commands
      ;;
    argument)
      case $line[1] in
{arguments}
      esac
      ;;
  esac
}}

{function} "$@"
"""


def function_of(program):
    return "_" + program.replace("-", "_")


def bash(program, commands):
    options, values = [], []
    for command in commands:
        names = " ".join(name for option in command.options for name in option.names)
        words = " ".join(each.names[0] for each in command.subcommands)
        pattern = command.name or "''"
        options.append(f"    {pattern}) options='{names}'" + (f" values='{words}'" if words else "") + " ;;")
        for option in (each for each in command.options if each.values):
            patterns = " | ".join(f"'{command.name} {name}'" for name in option.names)
            values.append(f"    {patterns}) values='{' '.join(option.values)}' ;;")
    return BASH.format(program=program, function=function_of(program), options="\n".join(options), values="\n".join(values))


def quoted(text):
    return "'" + text.replace("'", "'\\''") + "'"


def brief(text):
    """The first line of a text, as a description in brackets may hold it."""
    line = text.split("\n")[0].strip().rstrip(":;,")
    return line.replace("\\", "\\\\").replace("[", "\\[").replace("]", "\\]").replace(":", "\\:")


def action(option):
    if option.values:
        words = " ".join(option.values)
        return f"_sequence compadd - {words}" if option.is_list else f"({words})"
    return " " if option.is_number else "_files"


def specification(option):
    value = f":value:{action(option)}" if option.takes_value else ""
    text = quoted(f"[{brief(option.text)}]{value}")
    if len(option.names) == 1:
        return quoted(option.names[0])[:-1] + text[1:]
    return f"{quoted('(' + ' '.join(option.names) + ')')}{{{','.join(option.names)}}}{text}"


def zsh(program, commands):
    main, *others = commands
    arguments = []
    for command in others:
        lines = [specification(option) for option in command.options]
        lines += [quoted(f"{'*' if each.is_list else k + 1}:{each.names[0].lower()}:_files")
                  for k, each in enumerate(command.positionals)]
        body = " \\\n            ".join(lines)
        arguments.append(f"        {command.name})\n          _arguments \\\n            {body}\n          ;;")
    own = " \\\n".join("    " + specification(option) for option in main.options)
    names = "\n".join(f"        {quoted(each.names[0] + ':' + brief(each.text))}" for each in main.subcommands)
    return ZSH.format(program=program, function=function_of(program), own=own, commands=names,
                      arguments="\n".join(arguments))


def main():
    shell, program = sys.argv[1:]
    commands = command_help.read(program)
    sys.stdout.write({"bash": bash, "zsh": zsh}[shell](pathlib.Path(program).name, commands))


if __name__ == "__main__":
    main()
