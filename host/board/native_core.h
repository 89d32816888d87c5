// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The native core of configuration C behind the interface that ModelBoard needs.
#pragma once

#include "host/board/model_board.h"
#include "units/core_model.h"

namespace dynrt::host {

/// What the host has to know of a configuration; its name is the table's to give.
template <class C>
BoardInfo board_info_of() {
  BoardInfo info;
  info.packets = C::kPackets;
  info.cache_lines = C::kLines;
  info.stack_depth = C::kStackDepth;
  info.top_stack_depth = C::kTopStackDepth;
  info.lights = C::kLights;
  info.reflections = C::kReflections;
  info.crossing = C::kCrossing;
  info.clips_to_cube = kClipsToBox<C>;
  info.counters = C::kCounters;
  info.triangle_matrix = C::kTriangleMatrix;
  info.primitives = C::kPrimitives;
  info.triangle_test = C::kTriangleTest;
  info.address_bits = C::kAddressBits;
  info.matrix_bits = C::kMatrixBits;
  info.levels = C::kLevels;
  info.one_colour = C::kOneColour;
  info.uncompressed = C::kUncompressed;
  info.frame_words = frame_words_of<C>;
