#pragma once

#include <stdexcept>
#include <vector>

namespace fairlight::testing {

/// A source with numbers given by the test. It throws if it is asked for more.
class ScriptedSource {
 public:
  explicit ScriptedSource(std::vector<double> numbers) : numbers_(std::move(numbers)) {}

  double next() {
    if (used_ == numbers_.size()) throw std::logic_error("the script has no more numbers");
    return numbers_[used_++];
  }

  bool exhausted() const { return used_ == numbers_.size(); }

 private:
  std::vector<double> numbers_;
  std::size_t used_ = 0;
};

}  // namespace fairlight::testing
