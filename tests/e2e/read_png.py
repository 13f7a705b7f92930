"""Prints the size in pixels of a PNG, the resolution that it states, and some of its pixels.

    python3 read_png.py PICTURE.png [X,Y ...]

Prints JSON. Knows nothing but zlib and the PNG specification: 8 bits for each sample, not interlaced.
"""
import json
import struct
import sys
import zlib


def chunks(data):
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    at = 8
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at : at + 8])
        body = data[at + 8 : at + 8 + length]
        (checksum,) = struct.unpack(">I", data[at + 8 + length : at + 12 + length])
        assert checksum == zlib.crc32(kind + body), kind
        yield kind.decode(), body
        at += 12 + length


def rows(raw, width, height, samples):
    stride, before, at = width * samples, bytearray(width * samples), 0
    for _ in range(height):
        kind, row = raw[at], bytearray(raw[at + 1 : at + 1 + stride])
        at += 1 + stride
        for i in range(stride):
            left = row[i - samples] if i >= samples else 0
            up = before[i]
            corner = before[i - samples] if i >= samples else 0
            guess = left + up - corner
            nearest = min((left, up, corner), key=lambda value: abs(guess - value))
            row[i] = (row[i] + (0, left, up, (left + up) // 2, nearest)[kind]) & 255
        yield row
        before = row


data = open(sys.argv[1], "rb").read()
found = list(chunks(data))
width, height, depth, colors, _, _, interlaced = struct.unpack(">IIBBBBB", found[0][1])
assert depth == 8 and not interlaced
samples = {0: 1, 2: 3, 6: 4}[colors]
answer = {"width": width, "height": height, "samples": samples, "chunks": [kind for kind, _ in found]}
for kind, body in found:
    if kind == "pHYs":
        across, up, unit = struct.unpack(">IIB", body)
        answer["dots_in_a_metre"] = [across, up] if unit == 1 else None
places = [tuple(map(int, place.split(","))) for place in sys.argv[2:]]
if places:
    raw = zlib.decompress(b"".join(body for kind, body in found if kind == "IDAT"))
    pixels = list(rows(raw, width, height, samples))
    answer["pixels"] = [
        list(pixels[y % height][x % width * samples :][:samples]) for x, y in places
    ]
print(json.dumps(answer))
