#include <algorithm>
#include <filesystem>
#include <set>
#include <stdexcept>

#include <ImfChannelList.h>
#include <ImfChromaticities.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputPart.h>
#include <ImfIntAttribute.h>
#include <ImfMultiPartInputFile.h>
#include <ImfPartType.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>

#include <fairlight/render/picture_file.h>

namespace fairlight {
namespace {

constexpr int largest_side = 65536;

// What is wrong with a file, to follow its name.
struct Problem : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Three channels of a part, with the layers that say how noisy they are.
struct Colour {
  int part = 0;
  std::string layer;  // "" where the channels have plain names
  std::array<std::string, 3> channels, errors;
  ErrorLayer error_layer = ErrorLayer::none;
  std::string samples;  // the channel with the number of samples, or ""
};

bool has(const Imf::Header& header, const std::string& channel) {
  return header.channels().findChannel(channel) != nullptr;
}

std::array<std::string, 3> with_letters(const std::string& prefix, const std::string& letters) {
  return {prefix + letters[0], prefix + letters[1], prefix + letters[2]};
}

bool has_all(const Imf::Header& header, const std::array<std::string, 3>& channels) {
  return std::ranges::all_of(channels, [&](const std::string& name) { return has(header, name); });
}

// The prefixes of all channels: "" and, for example, "ViewLayer.Combined.".
std::set<std::string> prefixes(const Imf::Header& header) {
  std::set<std::string> all;
  for (auto i = header.channels().begin(); i != header.channels().end(); ++i) {
    const std::string name = i.name();
    const std::size_t dot = name.rfind('.');
    all.insert(dot == std::string::npos ? "" : name.substr(0, dot + 1));
  }
  return all;
}

// Layers that are no picture: errors, and what renderers write beside a picture's light.
bool is_auxiliary(const std::string& prefix) {
  static const std::set<std::string> names{
      "error.", "Variance.", "RelativeVariance.", "Albedo.", "albedo.", "normal.", "N.", "Ns.", "P.", "position."};
  return names.contains(prefix) || prefix.starts_with("m2_");
}

void find_errors(const Imf::Header& header, Colour& colour) {
  const std::string prefix = colour.layer.empty() ? "" : colour.layer + ".";
  const std::string letters{colour.channels[0].back(), colour.channels[1].back(), colour.channels[2].back()};
  const auto take = [&](const std::string& error_prefix, ErrorLayer kind) {
    const auto names = with_letters(error_prefix, letters);
    if (colour.error_layer != ErrorLayer::none || !has_all(header, names)) return;
    colour.errors = names;
    colour.error_layer = kind;
  };
  take(prefix + "error.", ErrorLayer::standard_error);
  take(prefix + "Variance.", ErrorLayer::variance);
  if (!prefix.empty()) take("m2_" + prefix, ErrorLayer::second_moment);
  if (has(header, prefix + "samples.N")) colour.samples = prefix + "samples.N";
}

std::vector<Colour> colours_of(const Imf::Header& header, int part, const std::string& letters) {
  std::vector<Colour> found;
  for (const std::string& prefix : prefixes(header)) {
    const auto channels = with_letters(prefix, letters);
    if (is_auxiliary(prefix) || !has_all(header, channels)) continue;
    const std::string layer = prefix.empty() ? "" : prefix.substr(0, prefix.size() - 1);
    found.push_back({part, layer, channels, {}, ErrorLayer::none, {}});
    find_errors(header, found.back());
  }
  return found;
}

std::string part_name(const Imf::MultiPartInputFile& file, int part) {
  return file.header(part).hasName() ? file.header(part).name() : std::to_string(part);
}

// How a user names a colour: by its part where there are several, and by its layer.
std::string full_name(const Imf::MultiPartInputFile& file, const Colour& colour) {
  if (file.parts() == 1) return colour.layer.empty() ? "R, G, B" : colour.layer;
  return part_name(file, colour.part) + (colour.layer.empty() ? "" : "." + colour.layer);
}

[[noreturn]] void refuse_without_colour(const Imf::MultiPartInputFile& file, const std::string& layer) {
  for (int part = 0; part < file.parts(); ++part) {
    const Imf::Header& header = file.header(part);
    if (header.hasType() && Imf::isDeepData(header.type()))
      throw Problem("holds deep pixels (flatten it to R, G, B)");
    if (has(header, "RY") && has(header, "BY"))
      throw Problem("holds luminance and chroma, Y, RY, BY (save it as R, G, B)");
    if (has(header, "Y")) throw Problem("holds luminance alone, the channel Y (save it as R, G, B)");
  }
  throw Problem(layer.empty()
                    ? "has no channels R, G, B (save the picture as linear R, G, B)"
                    : "has no layer or part \"" + layer + "\" with channels R, G, B (give the name of one)");
}

// Of several colours the one that is named, or that has no layer's name, as the renderer's result.
Colour chosen(const Imf::MultiPartInputFile& file, std::vector<Colour> all, const std::string& layer) {
  if (layer.empty() && file.parts() == 1 && all.size() > 1) {
    const auto plain = std::ranges::find_if(all, [](const Colour& c) { return c.layer.empty(); });
    if (plain != all.end()) return *plain;
  }
  const bool nameless = file.parts() == 1 && all.size() == 1 && all.front().layer.empty();
  if (!layer.empty() && !nameless) {
    std::erase_if(all, [&](const Colour& c) {
      return c.layer != layer && full_name(file, c) != layer && part_name(file, c.part) != layer;
    });
  }
  if (all.empty()) refuse_without_colour(file, layer);
  if (all.size() == 1) return all.front();
  std::string names;
  for (const Colour& c : all) names += (names.empty() ? "\"" : ", \"") + full_name(file, c) + "\"";
  throw Problem("has several pictures: " + names + " (choose one by --layer)");
}

Colour choose(const Imf::MultiPartInputFile& file, const std::string& layer, bool with_errors) {
  std::vector<Colour> all, moments;
  for (int part = 0; part < file.parts(); ++part) {
    for (const Colour& c : colours_of(file.header(part), part, "RGB")) all.push_back(c);
    for (const Colour& c : colours_of(file.header(part), part, "XYZ"))
      if (c.error_layer == ErrorLayer::second_moment) moments.push_back(c);
  }
  const bool has_errors =
      std::ranges::any_of(all, [](const Colour& c) { return c.error_layer != ErrorLayer::none; });
  return chosen(file, with_errors && !has_errors && !moments.empty() ? moments : all, layer);
}

void require_readable(const Imf::MultiPartInputFile& file, const Colour& colour) {
  const Imf::Header& header = file.header(colour.part);
  if (header.hasType() && Imf::isDeepData(header.type()))
    throw Problem("holds deep pixels (flatten it to R, G, B)");
  const Imath::Box2i window = header.dataWindow();
  const auto side = [](int from, int to) { return static_cast<long long>(to) - from + 1; };
  if (side(window.min.x, window.max.x) > largest_side || side(window.min.y, window.max.y) > largest_side) {
    throw Problem("has " + std::to_string(side(window.min.x, window.max.x)) + " x " +
                  std::to_string(side(window.min.y, window.max.y)) + " pixels (at most 65536 a side can be read)");
  }
  for (const std::string& name : colour.channels) {
    const Imf::Channel& channel = header.channels()[name];
    if (channel.xSampling != 1 || channel.ySampling != 1)
      throw Problem("has fewer samples than pixels in " + name + " (save it without subsampling)");
    if (channel.type == Imf::UINT) throw Problem("holds whole numbers in " + name + " (save it as half or float)");
  }
  if (!file.partComplete(colour.part)) throw Problem("is truncated (copy or render it again)");
}

std::array<double, 8> chromaticities_of(const Imf::Header& header) {
  const Imf::Chromaticities c =
      Imf::hasChromaticities(header) ? Imf::chromaticities(header) : Imf::Chromaticities();
  return {c.red.x, c.red.y, c.green.x, c.green.y, c.blue.x, c.blue.y, c.white.x, c.white.y};
}

}  // namespace

struct PictureFile::State {
  std::string path;
  Imf::MultiPartInputFile file;
  Colour colour;
  std::array<double, 8> chromaticities{};

  State(const std::string& name, const std::string& layer, bool with_errors)
      : path(name), file(name.c_str()), colour(choose(file, layer, with_errors)) {
    require_readable(file, colour);
    chromaticities = chromaticities_of(header());
  }

  const Imf::Header& header() const { return file.header(colour.part); }
};

PictureFile::PictureFile(const std::string& path, const std::string& layer, bool with_errors) {
  if (!std::filesystem::is_regular_file(path)) throw std::runtime_error("there is no file \"" + path + "\"");
  try {
    state_ = std::make_unique<State>(path, layer, with_errors);
  } catch (const Problem& problem) {
    throw std::runtime_error("\"" + path + "\" " + problem.what());
  } catch (const std::exception& error) {
    throw std::runtime_error("\"" + path + "\" cannot be read as OpenEXR (" + error.what() + ")");
  }
}

PictureFile::~PictureFile() = default;
PictureFile::PictureFile(PictureFile&&) noexcept = default;

const std::string& PictureFile::path() const { return state_->path; }
const std::array<std::string, 3>& PictureFile::channels() const { return state_->colour.channels; }
const std::array<double, 8>& PictureFile::chromaticities() const { return state_->chromaticities; }
ErrorLayer PictureFile::error_layer() const { return state_->colour.error_layer; }

PixelWindow PictureFile::data_window() const {
  const Imath::Box2i& window = state_->header().dataWindow();
  return {window.min.x, window.min.y, window.max.x + 1, window.max.y + 1};
}

std::string PictureFile::channel_letters() const {
  return {channels()[0].back(), channels()[1].back(), channels()[2].back()};
}

bool PictureFile::half() const {
  return std::ranges::any_of(
      channels(), [&](const std::string& name) { return state_->header().channels()[name].type == Imf::HALF; });
}

std::optional<double> PictureFile::samples_per_pixel() const {
  const auto* value = state_->header().findTypedAttribute<Imf::IntAttribute>("samplesPerPixel");
  return value == nullptr ? std::nullopt : std::optional<double>(value->value());
}

std::string PictureFile::attribute(const std::string& name) const {
  const auto* value = state_->header().findTypedAttribute<Imf::StringAttribute>(name);
  return value == nullptr ? "" : value->value();
}

// OpenEXR fills whole rows, so the columns of the window are copied out of them.
PixelBlock PictureFile::read(const PixelWindow& window) {
  const PixelWindow all = data_window();
  if (!all.contains(window)) throw std::invalid_argument("the pixels to read are outside of the data window");
  PixelBlock block;
  const Colour& colour = state_->colour;
  std::vector<std::pair<std::string, std::vector<float>*>> planes;
  for (std::size_t c = 0; c < 3; ++c) {
    planes.emplace_back(colour.channels[c], &block.colour[c]);
    if (colour.error_layer != ErrorLayer::none) planes.emplace_back(colour.errors[c], &block.error[c]);
  }
  if (!colour.samples.empty()) planes.emplace_back(colour.samples, &block.samples);
  const auto width = static_cast<std::size_t>(all.width()), rows = static_cast<std::size_t>(window.height());
  Imf::FrameBuffer buffer;
  for (auto& [name, plane] : planes) {
    plane->resize(width * rows);
    buffer.insert(name, Imf::Slice::Make(Imf::FLOAT, plane->data(), Imath::V2i(all.x0, window.y0),
                                         static_cast<std::int64_t>(width), static_cast<std::int64_t>(rows)));
  }
  try {
    Imf::InputPart part(state_->file, colour.part);
    part.setFrameBuffer(buffer);
    part.readPixels(window.y0, window.y1 - 1);
  } catch (const std::exception& error) {
    throw std::runtime_error("\"" + path() + "\" cannot be read to its end (" + error.what() + ")");
  }
  for (auto& [name, plane] : planes) {
    for (std::size_t y = 0; y < rows; ++y) {
      const auto first = plane->begin() + static_cast<std::ptrdiff_t>(y * width) + (window.x0 - all.x0);
      std::copy(first, first + window.width(), plane->begin() + static_cast<std::ptrdiff_t>(y) * window.width());
    }
    plane->resize(static_cast<std::size_t>(window.width()) * rows);
  }
  return block;
}

}  // namespace fairlight
