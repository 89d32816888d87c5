// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The one thread that renders. It runs the tasks of the server's threads one after the other.
#pragma once

#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>

namespace dynrt::host {

class RenderingThread {
 public:
  RenderingThread() : thread_([this] { work(); }) {}
  /// Waits for the task that runs; tasks that wait are dropped.
  ~RenderingThread() {
    {
      const std::lock_guard lock(mutex_);
      over_ = true;
    }
    more_.notify_one();
    thread_.join();
  }

  /// Returns the result of `act`, or throws its exception. urgent() counts the urgent tasks that
  /// wait.
  template <class Act>
  auto run(bool is_urgent, Act act) {
    auto task = std::make_shared<std::packaged_task<decltype(act())()>>(std::move(act));
    auto result = task->get_future();
    {
      const std::lock_guard lock(mutex_);
      waiting_.emplace_back([this, is_urgent, task] {
        urgent_ -= is_urgent;
        (*task)();
      });
      urgent_ += is_urgent;
    }
    more_.notify_one();
    return result.get();
  }
  const std::atomic<unsigned>& urgent() const { return urgent_; }

 private:
  void work() {
    for (;;) {
      std::unique_lock lock(mutex_);
      more_.wait(lock, [this] { return over_ || !waiting_.empty(); });
      if (over_) return;
      const std::function<void()> act = std::move(waiting_.front());
      waiting_.pop_front();
      lock.unlock();
      act();
    }
  }

  std::mutex mutex_;
  std::condition_variable more_;
  std::deque<std::function<void()>> waiting_;
  bool over_ = false;
  std::atomic<unsigned> urgent_ = 0;
  std::thread thread_;  ///< the last member, as it uses all others from its start
};

}  // namespace dynrt::host
