#include <stdexcept>
#include <string>

#include <fairlight/render/film.h>

namespace fairlight {

Film::Film(int width, int height) : width_(width), height_(height) {
  constexpr int largest = 65536;
  if (width < 1 || height < 1 || width > largest || height > largest) {
    throw std::invalid_argument("an image of " + std::to_string(width) + " x " + std::to_string(height) +
                                " pixels (width and height must be in 1 .. 65536)");
  }
  pixels_.resize(index(0, height));
}

void Film::refuse(int x, int y, const std::exception& error) {
  throw std::domain_error("pixel (" + std::to_string(x) + ", " + std::to_string(y) + "): " + error.what());
}

void Film::add(int x, int y, const Rgb<double>& sample) {
  add_all(x, y, std::array{sample[0], sample[1], sample[2]});
}

void Film::merge(const Film& other) {
  if (width_ != other.width_ || height_ != other.height_) {
    throw std::invalid_argument("films of different sizes cannot be merged");
  }
  for (std::size_t i = 0; i < pixels_.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) pixels_[i][c].merge(other.pixels_[i][c]);
  }
}

Rgb<double> Film::mean(int x, int y) const {
  const Pixel& pixel = at(x, y);
  return {pixel[0].mean(), pixel[1].mean(), pixel[2].mean()};
}

}  // namespace fairlight
