# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""What hls/configs/generate refuses of the pixels in the memory, as refused_test.py of all else."""

import unittest

from generate_case import GenerateCase, listing


class RefusedPixels(GenerateCase):
    def test_short_pixels_lie_behind_a_port(self) -> None:
        self.assert_key_refused(
            "pixel_bits",
            24,
            "(bits of a pixel in the memory: 32, a byte for each colour and one that is empty, or "
            "16, five for red and blue and six for green) is 24; it must be a power of two from 16 "
            "to 32",
        )
        self.assert_refused(
            listing({"pixel_bits": 16}),
            "configuration 'tiny': with memory \"banks\" the key 'pixel_bits' must be 32, as a "
            "bank's word holds one pixel; it is 16",
        )
        self.assert_refused(
            listing({"pixel_bits": 16, "memory": "port", "scan_out": True}),
            "configuration 'tiny': with pixel_bits 16 the key 'scan_out' must be false, as the VGA "
            "display takes a pixel of each word of a bank; it is true",
        )
        self.assertIn("kPixelBits = 16;", self.written(pixel_bits=16, memory="port"))


if __name__ == "__main__":
    unittest.main()
