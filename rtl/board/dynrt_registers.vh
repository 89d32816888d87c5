// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The register map of the board, the one source of it: board_registers.v includes this file and
// cmake/RegisterMap.cmake makes the host's registers.h from it. Byte addresses of 32-bit registers;
// R read, W write.
//
// What the board refuses has no effect and sets STATUS.refused, until the next start that it
// accepts or the next reset. While a frame is being rendered it refuses a start, a write to a FRAME
// register or to MEMORY_BASE, and each access to the SRAM window, of which a refused read gives
// zero. It refuses a start too if the core cannot render the frame: `packets` is 0 or more than
// LIMITS says, or `line_mask` + 1 is not a power of two or more than LIMITS says.
//
// A board may be built so that FRAME and SCAN read as zero (READ_BACK of board_registers.v), as that
// of the ULX3S is.

localparam [31:0] ID_VALUE = 32'h44595254;      // "DYRT"
localparam [31:0] VERSION_VALUE = 32'h00020004; // map 2.4: major in the upper half, minor below

localparam [25:0] REG_ID = 26'h000;              // R  ID_VALUE
localparam [25:0] REG_VERSION = 26'h004;         // R  VERSION_VALUE
localparam [25:0] REG_LIMITS = 26'h008;          // R  packets in bits 15:0, cache lines in 31:16
localparam [25:0] REG_CONTROL = 26'h00c;         // W  a one starts what its bit stands for
localparam [25:0] REG_STATUS = 26'h010;          // R  see the STATUS bits
localparam [25:0] REG_IRQ_ENABLE = 26'h014;      // RW bit 0: the interrupt line follows IRQ_PENDING
localparam [25:0] REG_IRQ_PENDING = 26'h018;     // RW bit 0: a frame is done; writing a one clears it
localparam [25:0] REG_CYCLES_LOW = 26'h01c;      // R  clocks of the frame, from first start token to done
localparam [25:0] REG_CYCLES_HIGH = 26'h020;     // R  upper half of them
localparam [25:0] REG_COUNTER_ADDRESS = 26'h024; // W  which of the core's counters COUNTER_DATA shows
localparam [25:0] REG_COUNTER_DATA = 26'h028;    // R  its count
localparam [25:0] REG_FRAME_WORDS = 26'h02c;     // R  how many FRAME registers there are
localparam [25:0] REG_SCAN_WORDS = 26'h030;      // R  how many SCAN registers there are; 0: no scan-out
localparam [25:0] REG_SCAN_CLOCKS = 26'h034;     // RW clocks a pixel takes, 2 to 255, or 1 on a DVI link, which keeps time itself; 0: scan-out is off
localparam [25:0] REG_SCAN_SHOWN = 26'h038;      // R  first word of the picture taken in the last blank
localparam [25:0] REG_SCAN_FRAMES = 26'h03c;     // R  vertical blanks since it was switched on
localparam [25:0] REG_MEMORY_ERROR = 26'h040;    // RW see the MEMORY_ERROR bits; writing a one to bit 0 clears it
localparam [25:0] REG_MEMORY_ERROR_ADDRESS = 26'h044; // R  byte of the core's memory that it was for
localparam [25:0] REG_MEMORY_BASE_LOW = 26'h048; // RW where the memory begins on its bus, a multiple of 32 MB
localparam [25:0] REG_MEMORY_BASE_HIGH = 26'h04c; // RW upper half of it; bits that the bus lacks are 0
localparam [25:0] REG_FRAME = 26'h100;           // RW first of the FRAME_WORDS registers of a frame (hls/units/frame.h)
localparam [25:0] REG_SCAN = 26'h200;            // RW first of the SCAN_WORDS registers of the scan-out (hls/units/scan_out.h)

localparam FRAME_WORD_BITS = 6; // there is room for 2^6 FRAME registers

localparam CONTROL_START = 0; // reset the core, clear its counters, render a frame; may be refused
localparam CONTROL_RESET = 1; // reset the core and give up the frame; no interrupt follows

localparam STATUS_BUSY = 0;    // a frame is being rendered or the core is being reset
localparam STATUS_DONE = 1;    // the last frame that was started is complete
localparam STATUS_REFUSED = 2; // an access or a start was refused since the last start or reset
localparam STATUS_MEMORY_ERROR = 3; // bit 0 of MEMORY_ERROR
localparam STATUS_DISPLAY_MISSED = 4; // the display has missed pixels since it was switched on

// What MEMORY_ERROR says of the first access that the memory answered with an error.
localparam MEMORY_ERROR_SEEN = 0;     // there was one since the host cleared this bit
localparam MEMORY_ERROR_WRITE = 1;    // it was a write
localparam MEMORY_ERROR_RESPONSE = 2; // and the next bit: 2 error of the memory, 3 no memory there

// Byte address of a word of the SRAM: {1, bank [24:22], word [21:2], 00}.
localparam WINDOW_BIT = 25;
localparam WINDOW_BANK_LOW = 22;
localparam WINDOW_WORD_LOW = 2;
