#pragma once

#include <functional>

namespace fairlight {

/// Runs work(0) .. work(units - 1) on `threads` threads, each unit once, in no particular order. Units are fixed by
/// the caller and each writes its own memory, so results do not depend on the number of threads. If units throw,
/// the exception of the lowest unit that threw is rethrown when all threads have stopped. Throws
/// std::invalid_argument when threads < 1.
///
/// Plain threads: the thread sanitizer sees through them, where it reports races inside a scheduler library that
/// was built without it, and would have to be told to look away.
void for_each_unit(int units, int threads, const std::function<void(int)>& work);

/// The number of threads that the machine runs at once, at least 1.
int hardware_threads();

}  // namespace fairlight
