// libFuzzer's entry for the reader that FAIRLIGHT_READER names.
#include <fuzz/readers.h>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fairlight::fuzz::FAIRLIGHT_READER({data, size});
  return 0;
}
