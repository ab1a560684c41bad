#pragma once

#include <cstddef>
#include <functional>

namespace fairlight {

/// Called with the fraction done, in (0,1], from one thread at a time.
using Progress = std::function<void(double)>;

/// Runs work(0) .. work(units - 1) on `threads` threads, each unit once, in no particular order.
/// The caller fixes the units and each writes its own memory, so results do not depend on the
/// number of threads. If units throw, rethrows the exception of the lowest of them after all
/// threads have stopped. Reports progress after each unit. Throws std::invalid_argument when
/// threads < 1.
/// Uses plain threads: the thread sanitizer reports false races inside a scheduler library that was
/// not built with it.
void for_each_unit(std::size_t units, int threads, const std::function<void(std::size_t)>& work,
                   const Progress& progress = {});

/// The number of hardware threads of the machine, at least 1.
int hardware_threads();

}  // namespace fairlight
