#!/usr/bin/env python3
# SPDX-FileCopyrightText: The Triplex authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares two .vtu files array by array, point by point.

Usage: compare.py A.vtu B.vtu TOLERANCE

Both must be as Triplex writes them (inline base64, zlib, little-endian), with equal tets in any
order. Prints for each array of B the largest difference of an entry relative to the largest entry
of B. Exit code 1 if one exceeds the tolerance or something does not correspond.
"""
import base64
import re
import struct
import sys
import zlib

CODES = {"Float64": "d", "Int64": "q", "UInt8": "B"}


def decode(text, kind):
    """The numbers of one DataArray: a header with sizes, then compressed blocks."""
    text = text.strip()
    blocks = struct.unpack("<Q", base64.b64decode(text[:12])[:8])[0]
    length = 8 * (3 + blocks)
    digits = (length + 2) // 3 * 4
    sizes = struct.unpack("<%dQ" % (3 + blocks), base64.b64decode(text[:digits])[:length])[3:]
    data, at, raw = base64.b64decode(text[digits:]), 0, b""
    for size in sizes:
        raw += zlib.decompress(data[at:at + size])
        at += size
    code = CODES[kind]
    return struct.unpack("<%d%s" % (len(raw) // struct.calcsize(code), code), raw)


def read(name):
    with open(name, encoding="ascii") as file:
        content = file.read()
    found = re.findall(r'<DataArray type="(\w+)" Name="(\w+)"[^>]*format="binary"[^>]*>([^<]*)',
                       content)
    return {name: decode(text, kind) for kind, name, text in found if kind in CODES}


def tets(arrays):
    ids = arrays["connectivity"]
    return {tuple(sorted(ids[i:i + 4])) for i in range(0, len(ids), 4)}


def main():
    a, b, tolerance = read(sys.argv[1]), read(sys.argv[2]), float(sys.argv[3])
    print(f"{sys.argv[1]} against {sys.argv[2]}, tolerance {tolerance:g}")
    good = tets(a) == tets(b)
    print("  tets", "equal" if good else "DIFFER")
    for name in sorted(set(b) - {"connectivity", "offsets", "types"}):
        if len(a.get(name, ())) != len(b[name]):
            print(f"  {name}: missing or of another size")
            good = False
            continue
        scale = max(map(abs, b[name]))
        difference = max(abs(x - y) for x, y in zip(a[name], b[name]))
        fits = difference <= tolerance * scale
        print(f"  {name}: {difference:.2g} of {scale:.3g} {'' if fits else 'TOO LARGE'}")
        good = good and fits
    sys.exit(0 if good else 1)


main()
