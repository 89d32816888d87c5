/* Copyright the dynrt authors.
 * SPDX-License-Identifier: Apache-2.0
 *
 * Made by scripts/docs --renew of rtl/board/dynrt_registers.vh; do not edit. DYNRT_REG_ is the byte
 * address of a register of 32 bits, R read, W write; the others are values and numbers of
 * bits.
 */
#ifndef DYNRT_REGISTERS_H
#define DYNRT_REGISTERS_H

#define DYNRT_ID_VALUE 0x44595254u /* "DYRT" */
#define DYNRT_VERSION_VALUE 0x00020004u /* map 2.4: major in the upper half, minor below */
#define DYNRT_REG_ID 0x000u /* R  ID_VALUE */
#define DYNRT_REG_VERSION 0x004u /* R  VERSION_VALUE */
#define DYNRT_REG_LIMITS 0x008u /* R  packets in bits 15:0, cache lines in 31:16 */
#define DYNRT_REG_CONTROL 0x00cu /* W  a one starts what its bit stands for */
#define DYNRT_REG_STATUS 0x010u /* R  see the STATUS bits */
#define DYNRT_REG_IRQ_ENABLE 0x014u /* RW bit 0: the interrupt line follows IRQ_PENDING */
#define DYNRT_REG_IRQ_PENDING 0x018u /* RW bit 0: a frame is done; writing a one clears it */
#define DYNRT_REG_CYCLES_LOW 0x01cu /* R  clocks of the frame, from first start token to done */
#define DYNRT_REG_CYCLES_HIGH 0x020u /* R  upper half of them */
#define DYNRT_REG_COUNTER_ADDRESS 0x024u /* W  which of the core's counters COUNTER_DATA shows */
#define DYNRT_REG_COUNTER_DATA 0x028u /* R  its count */
#define DYNRT_REG_FRAME_WORDS 0x02cu /* R  how many FRAME registers there are */
#define DYNRT_REG_SCAN_WORDS 0x030u /* R  how many SCAN registers there are; 0: no scan-out */
#define DYNRT_REG_SCAN_CLOCKS 0x034u /* RW clocks a pixel takes, 2 to 255, or 1 on a DVI link, which keeps time itself; 0: scan-out is off */
#define DYNRT_REG_SCAN_SHOWN 0x038u /* R  first word of the picture taken in the last blank */
#define DYNRT_REG_SCAN_FRAMES 0x03cu /* R  vertical blanks since it was switched on */
#define DYNRT_REG_MEMORY_ERROR 0x040u /* RW see the MEMORY_ERROR bits; writing a one to bit 0 clears it */
#define DYNRT_REG_MEMORY_ERROR_ADDRESS 0x044u /* R  byte of the core's memory that it was for */
#define DYNRT_REG_MEMORY_BASE_LOW 0x048u /* RW where the memory begins on its bus, a multiple of 32 MB */
#define DYNRT_REG_MEMORY_BASE_HIGH 0x04cu /* RW upper half of it; bits that the bus lacks are 0 */
#define DYNRT_REG_FRAME 0x100u /* RW first of the FRAME_WORDS registers of a frame (hls/units/frame.h) */
#define DYNRT_REG_SCAN 0x200u /* RW first of the SCAN_WORDS registers of the scan-out (hls/units/scan_out.h) */
#define DYNRT_FRAME_WORD_BITS 6u /* there is room for 2^6 FRAME registers */
#define DYNRT_CONTROL_START 0u /* reset the core, clear its counters, render a frame; may be refused */
#define DYNRT_CONTROL_RESET 1u /* reset the core and give up the frame; no interrupt follows */
#define DYNRT_STATUS_BUSY 0u /* a frame is being rendered or the core is being reset */
#define DYNRT_STATUS_DONE 1u /* the last frame that was started is complete */
#define DYNRT_STATUS_REFUSED 2u /* an access or a start was refused since the last start or reset */
#define DYNRT_STATUS_MEMORY_ERROR 3u /* bit 0 of MEMORY_ERROR */
#define DYNRT_STATUS_DISPLAY_MISSED 4u /* the display has missed pixels since it was switched on */
#define DYNRT_MEMORY_ERROR_SEEN 0u /* there was one since the host cleared this bit */
#define DYNRT_MEMORY_ERROR_WRITE 1u /* it was a write */
#define DYNRT_MEMORY_ERROR_RESPONSE 2u /* and the next bit: 2 error of the memory, 3 no memory there */
#define DYNRT_WINDOW_BIT 25u
#define DYNRT_WINDOW_BANK_LOW 22u
#define DYNRT_WINDOW_WORD_LOW 2u

#endif
