#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fairlight/stats/text.h>
#include <fairlight/validation/report/canvas.h>

namespace fairlight {

/// The rectangle of a canvas that a chart fills, with its axes.
class Axes {
 public:
  struct Place {
    int left, top, right, bottom;
  };
  struct Range {
    double low, high;
  };

  Axes(Canvas& canvas, const Place& place, const Range& across, const Range& up)
      : canvas_(canvas), place_(place), across_(across), up_(up) {}

  double x(double value) const {
    return place_.left + (place_.right - place_.left) * (value - across_.low) / (across_.high - across_.low);
  }
  /// The y coordinate of a value. Values beyond the axis are clamped to its end.
  double y(double value) const {
    const double inside = std::clamp(value, up_.low, up_.high);
    return place_.bottom - (place_.bottom - place_.top) * (inside - up_.low) / (up_.high - up_.low);
  }

  void draw(const std::string& label_across, const std::string& label_up) const {
    constexpr Colour grey{225, 225, 225};
    constexpr Colour black{0, 0, 0};
    for (double value : ticks(up_, 5)) {
      const int at = pixel(y(value));
      canvas_.rectangle(place_.left, at, place_.right, at + 1, grey);
      canvas_.text_to(place_.left - 6, at - 7, label(value));
    }
    for (double value : ticks(across_, 4)) {
      const int at = pixel(x(value));
      const std::string words = label(value);
      canvas_.rectangle(at, place_.bottom, at + 2, place_.bottom + 6, black);
      canvas_.text(at - static_cast<int>(words.size()) * Canvas::letter_width / 2, place_.bottom + 10, words);
    }
    canvas_.rectangle(place_.left, place_.top, place_.left + 2, place_.bottom, black);
    canvas_.rectangle(place_.left, place_.bottom, place_.right, place_.bottom + 2, black);
    canvas_.text_to(place_.right, place_.bottom + 30, label_across);
    canvas_.text(place_.left, place_.top - 22, label_up);
  }

  static int pixel(double place) { return static_cast<int>(std::lround(place)); }

 private:
  // Round values for ticks: about `about` of them, with a step of 1, 2 or 5 times a power of ten.
  static std::vector<double> ticks(const Range& range, int about) {
    const double rough = (range.high - range.low) / about;
    const double power = std::pow(10, std::floor(std::log10(rough)));
    const double step = power * (rough < 1.5 * power ? 1 : rough < 3.5 * power ? 2 : rough < 7.5 * power ? 5 : 10);
    std::vector<double> values;
    const double first = std::ceil(range.low / step - 1e-9);
    for (double k = first; k * step <= range.high + 1e-9 * step; ++k)
      values.push_back(k * step + 0.0);  // turns -0 into +0
    return values;
  }

  static std::string label(double value) { return formatted("%.4g", value); }

  Canvas& canvas_;
  Place place_;
  Range across_, up_;
};

}  // namespace fairlight
