"""Text from a file: drawn as it stands, never as a formula, and never longer than there is room."""
import unicodedata

UNSEEN = ("Cc", "Cs", "Co", "Cn")  # control characters, halves of pairs, what is not assigned


def cleaned(text, longest):
    """The text on one line, cut to `longest` characters."""
    text = text[: 4 * longest]
    text = "".join(" " if unicodedata.category(letter) in UNSEEN else letter for letter in text)
    text = text.strip()
    return text if len(text) <= longest else text[: longest - 1].rstrip() + "…"


def literal(artist, text, longest):
    """Gives a matplotlib text its text."""
    artist.set_parse_math(False)
    artist.set_text(cleaned(text, longest))
