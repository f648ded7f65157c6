// Memory that is to be had, and a room that no more goes into than fits.
#pragma once
#include <condition_variable>
#include <mutex>

namespace percal {

// Bytes that programs may still take here: what the kernel says is available, less where a control group (a container) has less left.
// Infinity where neither says.
double available_memory();

// Bytes that this process holds.
double memory_of_this_process();

// Lets work in as long as all that is inside fits. What is larger than the room goes in alone.
class MemoryRoom {
 public:
  explicit MemoryRoom(double bytes) : bytes_(bytes) {}

  // Of one piece of work, as long as this is alive. Waits for its place.
  class Place {
   public:
    Place(MemoryRoom& room, double bytes);
    ~Place();
    Place(const Place&) = delete;
    Place& operator=(const Place&) = delete;

   private:
    MemoryRoom& room_;
    const double bytes_;
  };

 private:
  const double bytes_;
  double taken_ = 0;
  int inside_ = 0;
  std::mutex mutex_;
  std::condition_variable left_;
};

}  // namespace percal
