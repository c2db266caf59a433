"""What pictures need of the scene in results.vtkhdf, which weavefront writes with a line for every value."""
import re

ESCAPES = {"n": " ", "t": " ", "r": " ", "0": " "}


def title_of(scene):
    """The title without its quotes, or nothing."""
    match = re.search(r"^title:[ \t]*(.*)$", scene, re.MULTILINE)
    text = match[1].strip() if match else ""
    if len(text) > 1 and text[0] == text[-1] == '"':
        return re.sub(
            r"\\(?:x([0-9a-fA-F]{2})|u([0-9a-fA-F]{4})|U([0-9a-fA-F]{8})|(.))", unescaped, text[1:-1]
        )
    if len(text) > 1 and text[0] == text[-1] == "'":
        return text[1:-1].replace("''", "'")
    return text


def unescaped(match):
    """The character of an escape in double quotes."""
    code = next((group for group in match.groups()[:3] if group), None)
    if code is None:
        return ESCAPES.get(match[4], match[4])
    return chr(int(code, 16)) if int(code, 16) < 0x110000 else " "


def symmetry_of(scene):
    """Whether only x >= 0, y >= 0 is modelled, or None where the scene does not say."""
    match = re.search(r"^[ \t]*symmetry:[ \t]*(.*(?:\n[ \t]*- *[xy]\b)*)", scene, re.MULTILINE)
    if not match:
        return None
    names = re.findall(r"\b[xy]\b", match[1].split("#")[0])
    return ("x" in names, "y" in names)
