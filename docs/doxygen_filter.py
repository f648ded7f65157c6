"""What Doxygen reads instead of a header: its plain // comments as documentation, in the group of its layer.

A comment above a declaration documents it, a comment behind one too; the comment at the top of a file documents the file, that of
LAYER.hpp the layer. Lines indented inside a comment are formulas or code and stay as they are. A Markdown file is given back
with its links to files that Doxygen does not see as plain text.
"""
import pathlib
import re
import sys


def escaped(text):
    return re.sub(r"([\\@<>#&])", r"\\\1", text.replace("%", "%%") if re.search(r"%\w", text) else text)


def preformatted(text):
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;").replace("\\", "\\\\").replace("@", "\\@")


def documentation(comment):
    """Lines of a // comment, without their indentation, as lines of documentation."""
    inside, lines = False, []
    for line in comment:
        text = line[2:].rstrip()
        indented = text.startswith("   ")
        if indented and not inside:
            lines.append("/// <pre>")
        if inside and not indented:
            lines.append("/// </pre>")
        inside = indented
        lines.append("/// " + (preformatted(text) if indented else escaped(text.strip())))
    if inside:
        lines.append("/// </pre>")
    return lines


def is_comment(line):
    return line.lstrip().startswith("//")


def split_code(line):
    """Code and the comment behind it; a // inside quotes is code."""
    quoted = re.match(r'((?:[^"/]|"(?:[^"\\]|\\.)*"|/(?!/))*)(//.*)$', line)
    return (quoted[1], quoted[2]) if quoted and quoted[1].strip() else (line, "")


def header(lines, layer, is_layer):
    top = []
    while lines and is_comment(lines[0]):
        top.append(lines.pop(0))
    if is_layer:
        title = top[0][2:].strip().rstrip(".") if top else layer
        yield f"/// \\defgroup {layer} {title}"
        yield from documentation(top[1:])
    else:
        yield "/// \\file"
        yield from documentation(top)
    block = []
    for line in lines:
        documented = bool(block) and not is_comment(line) and bool(line.strip())
        if is_comment(line):
            block.append(line.strip())
            continue
        if block:
            # A comment that a blank line follows is about a group of declarations, or nobody's.
            yield from documentation(block) if line.strip() else block
            block = []
        if re.match(r"namespace percal[\w:]* {$", line):
            yield line
            yield f"/// \\addtogroup {layer}"
            yield "/// @{"
            continue
        if re.match(r"}  // namespace percal", line):
            yield "/// @}"
        code, comment = split_code(line)
        behind = code.rstrip().endswith((";", ",", "{")) or re.search(r"\w\s*$", code)
        namespace = code.lstrip().startswith(("namespace", "}", "#"))
        if comment and behind and not namespace and not code.rstrip().endswith("{"):
            if documented:  # above and behind: one text
                yield "/// " + escaped(comment[2:].strip())
            yield code.rstrip() if documented else code + "///< " + escaped(comment[2:].strip())
        elif comment and re.match(r"(struct|class|enum class)\b.*{\s*$", code):
            yield "/// " + escaped(comment[2:].strip())
            yield code.rstrip()
        else:
            yield line
    yield from block


def page(text):
    text = re.sub(r"!\[([^\]]*)\]\([^)]*/([^)/]+\.svg)\)", r"![\1](\2)", text)
    return re.sub(r"(?<!!)\[([^\]]*)\]\((?!https?:)[^)]*\)", r"\1", text)


def main(path):
    text = pathlib.Path(path).read_text(encoding="utf-8")
    if path.endswith(".md"):
        print(page(text))
        return
    folder = pathlib.Path(path).parent
    is_layer = folder.name == "percal"
    layer = pathlib.Path(path).stem if is_layer else folder.name
    print("\n".join(header(text.split("\n"), layer, is_layer)))


if __name__ == "__main__":
    main(sys.argv[1])
