// Threads as far as they are to be had: a machine short of memory, or a container with a limit of processes, gives fewer.
#pragma once
#include <functional>
#include <thread>
#include <vector>

namespace percal {

// Threads that run work(1), work(2), ...: `wanted` of them, or as many as the machine gives, be it none. work must not throw.
std::vector<std::thread> threads_to_be_had(int wanted, const std::function<void(int)>& work);

// One for each core, at least one.
int threads_of_this_machine();

// work(0) ... work(count - 1), each on one of up to `threads` threads, the calling one among them; where no more are to be had the
// rest is done by those there are. Calls within calls share the threads: all together have at most one less than `threads` beside those that
// called. The first exception ends what has not begun and is thrown here, when all threads are done. A
// piece that finds no memory beside the others is done again, with the rest, when the calling thread is alone.
void side_by_side(int threads, int count, const std::function<void(int)>& work);

}  // namespace percal
