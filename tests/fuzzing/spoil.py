"""Ways to spoil a file: small damages of bytes, lines and numbers, chosen by a generator of random numbers."""

import bz2
import gzip
import io
import lzma
import re
import zipfile
from collections.abc import Callable
from random import Random

NUMBER = re.compile(rb"[-+]?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?")
WORDS = [
    b"nan", b"NaN", b"inf", b"-inf", b"1e999", b"1e300", b"-1e300", b"1e-320", b"0", b"-0", b"-1", b"1", b"2", b"3",
    b"65535", b"65536", b"2147483648", b"1000000000", b"99999999999999999999", b"-99999999999999999999", b"1,5",
    b"1d-3", b"1_000", b"0x10", b"1.#IND", b"word", b"", b"null", b"true", b"\xb2", b"\xd9\xa3", b"1e", b"--1", b"1e9",
]  # fmt: skip
INSERTS = [
    b"\0", b"\n", b"\r", b"\r\n", b"\t", b" ", b",", b";", b":", b"{", b"}", b"[", b"]", b'"', b"<", b"&", b"#",
    b"\\", b"/", b"\x1a", b"\xff", b"\xef\xbb\xbf", b"\xe4", b"\xed\xa0\x80", b"\xe2\x80\xa8", b"9" * 40, b"A" * 300,
    b"[" * 2000, b"{" * 2000, b"-", b".", b"e", b"\0" * 64, b"\x85",
]  # fmt: skip
PATTERNS = [
    b"\0\0", b"\xff\xff", b"\xff\x7f", b"\0\x80", b"\x01\0", b"\0\0\xc0\x7f", b"\0\0\x80\x7f", b"\xff\xff\xff\xff",
    b"\xff\xff\x7f\x7f", b"\xff\xff\xff\x7f", b"\0\xca\x9a\x3b",
]  # fmt: skip


def _place(content: bytes, rng: Random) -> int:
    """A byte, as often in the first few hundred as in all the rest: that is where the headers are."""
    return rng.randrange(min(len(content), 400) if rng.random() < 0.5 else len(content))


def _flip(content: bytes, rng: Random) -> bytes:
    k = _place(content, rng)
    return content[:k] + bytes([content[k] ^ (1 << rng.randrange(8))]) + content[k + 1 :]


def _overwrite(content: bytes, rng: Random) -> bytes:
    k, pattern = _place(content, rng), rng.choice(PATTERNS)
    return content[:k] + pattern + content[k + len(pattern) :]


def _insert(content: bytes, rng: Random) -> bytes:
    k = _place(content, rng)
    return content[:k] + rng.choice(INSERTS) + content[k:]


def _truncate(content: bytes, rng: Random) -> bytes:
    return content[: _place(content, rng)]


def _remove(content: bytes, rng: Random) -> bytes:
    k = _place(content, rng)
    return content[:k] + content[k + rng.randrange(1, 64) :]


def _repeat(content: bytes, rng: Random) -> bytes:
    k = _place(content, rng)
    piece = content[k : k + rng.randrange(1, 200)]
    return content[:k] + piece * rng.choice((2, 2, 50)) + content[k + len(piece) :]


def _number(content: bytes, rng: Random) -> bytes:
    places = [
        match.span() for match in NUMBER.finditer(content[: 400 if rng.random() < 0.5 else len(content)])
    ]
    if not places:
        return content
    start, stop = rng.choice(places)
    return content[:start] + rng.choice(WORDS) + content[stop:]


def _lines(content: bytes, rng: Random) -> bytes:
    lines = content.split(b"\n")
    a, b = (rng.randrange(min(len(lines), 40) if rng.random() < 0.5 else len(lines)) for _ in range(2))
    kind = rng.randrange(4)
    if kind == 0:
        del lines[a]
    elif kind == 1:
        lines.insert(b, lines[a])
    elif kind == 2:
        lines[a], lines[b] = lines[b], lines[a]
    else:
        lines[a] = lines[a][: len(lines[a]) // 2]
    return b"\n".join(lines)


def _word(content: bytes, rng: Random) -> bytes:
    """One word of the file in the place of another."""
    words = [match.span() for match in re.finditer(rb"[^\s,;\"]+", content[:4000])]
    if len(words) < 2:
        return content
    (a, b), (c, d) = rng.sample(words, 2)
    return content[:a] + content[c:d] + content[b:]


def _wide(content: bytes, rng: Random) -> bytes:
    """Other encodings and line ends."""
    return rng.choice((
        lambda: content.replace(b"\n", b"\r"),
        lambda: content.replace(b"\n", b"\r\n"),
        lambda: content.decode("latin-1").encode("utf-16"),
        lambda: content.decode("latin-1").encode("utf-16-be"),
        lambda: b"\xef\xbb\xbf" + content,
        lambda: content + b"\0" * 99,
        lambda: content.replace(b".", b","),
    ))()  # fmt: skip


DAMAGES: list[Callable[[bytes, Random], bytes]] = [
    _flip, _overwrite, _insert, _truncate, _remove, _repeat, _number, _number, _number, _lines, _word, _wide,
]  # fmt: skip

_COMPRESSED = {b"\x1f\x8b": gzip, b"BZh": bz2, b"\xfd7zX": lzma}


def spoil(content: bytes, rng: Random) -> bytes:
    """Do a few damages to a file; within what is compressed as often as to the whole."""
    if rng.random() < 0.5:
        for mark, module in _COMPRESSED.items():
            if content.startswith(mark):
                return module.compress(spoil(module.decompress(content), rng))
        if content.startswith(b"PK\x03\x04"):
            return _within_zip(content, rng)
    for _ in range(rng.choice((1, 1, 1, 2, 3, 6))):
        if content:
            content = rng.choice(DAMAGES)(content, rng)
    return content


def _within_zip(content: bytes, rng: Random) -> bytes:
    with zipfile.ZipFile(io.BytesIO(content)) as box:
        members = [(member.filename, box.read(member)) for member in box.infolist()]
    k = rng.randrange(len(members))
    name, inside = members[k]
    if rng.random() < 0.1:
        name = rng.choice(
            ("", "../x.bvh", "/x.bvh", "a\\b.bvh", "x.zip", "a/", "x\n.bvh", "__MACOSX/x.bvh", "x.c3d")
        )
    members[k] = (name, spoil(inside, rng))
    if rng.random() < 0.1:
        del members[k]
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w") as box:
        for name, inside in members:
            box.writestr(zipfile.ZipInfo(name), inside)
    return file.getvalue()
