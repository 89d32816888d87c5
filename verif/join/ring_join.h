// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// How the units of ring.h are joined.
#pragma once

#include <memory>
#include <vector>

#include "hls/join.h"
#include "join/ring.h"

namespace dynrt::ring {

struct Ring {
  Enter enter[2];
  Store store;
  Number number;
  Side side[2];
  Pair pair;
  Round round;

  hls::Join join;
  hls::Rows<uint<32>> salt = hls::Rows<uint<32>>(kItems);
  hls::Rows<uint<32>> result = hls::Rows<uint<32>>(kItems);
  std::shared_ptr<uint<8>> add = std::make_shared<uint<8>>();
  std::shared_ptr<hls::Fifo<Job>> job[2];
  std::shared_ptr<hls::Fifo<Item>> done;

  Ring() {
    join.unit("enter_0", "ring_enter", enter[0]);
    join.unit("enter_1", "ring_enter", enter[1]);
    join.unit("store", "ring_store", store);
    join.unit("number", "ring_number", number);
    join.unit("side_0", "ring_side", side[0]);
    join.unit("side_1", "ring_side", side[1]);
    join.unit("pair", "ring_pair", pair);
    join.unit("round", "ring_round", round);

    job[0] = join.input("job_0", enter[0].job);
    job[1] = join.input("job_1", enter[1].job);
    join.channel<Job>("entered", {&enter[0].out, &enter[1].out}, {&store.job});
    join.repeat("numbered", hls::Writers{&store.out}, number.job, 16);
    join.channel<Item>("item", hls::Writers(&number.item, hls::WriterFifo::kShort),
                       {&side[0].item, &side[1].item, &pair.before}, kItems);
    join.config("add", add, std::vector{&side[0].add});
    join.constant(side[1].add, uint<8>(77));
    join.channel("left", side[0].out, pair.side[0]);
    join.channel("right", side[1].out, pair.side[1]);
    join.sink("odd_left", side[0].odd);
    join.sink("odd_right", side[1].odd);
    join.channel<Item>("round", {&pair.out, &round.again}, {&round.item}, kItems);
    done = join.output("done", round.done);
    join.ram("note", store.note, std::array{&number.note, &pair.note});
    join.bank("salt", number.bank, salt);
    join.bank("result", round.result, result);
  }
};

}  // namespace dynrt::ring
