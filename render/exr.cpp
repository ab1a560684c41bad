#include <algorithm>
#include <filesystem>
#include <limits>
#include <stdexcept>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfStringAttribute.h>

#include <fairlight/estimators/vertex_source.h>
#include <fairlight/render/atomic_file.h>
#include <fairlight/render/picture.h>
#include <fairlight/render/raster.h>
#include <fairlight/stats/seed.h>
#include <fairlight/version.h>

namespace fairlight {
namespace {

constexpr std::array<const char*, 3> channel_names{"R", "G", "B"};
constexpr std::size_t halves = 2 * ExactMoments::word_count;  // 32-bit halves of a channel's state

class ExrStream : public Imf::OStream {
 public:
  ExrStream(AtomicFile& file, const std::string& path) : OStream(path.c_str()), file_(file) {}
  void write(const char bytes[], int n) override { file_.write({bytes, static_cast<std::size_t>(n)}); }
  std::uint64_t tellp() override { return file_.position(); }
  void seekp(std::uint64_t position) override { file_.seek(position); }

 private:
  AtomicFile& file_;
};

// One row of one channel at a time: planes of a row, in the order of `names`.
template <class Value>
struct Row {
  std::vector<std::string> names;
  std::vector<std::vector<Value>> planes;

  Row(std::vector<std::string> channel_list, int width) : names(std::move(channel_list)) {
    planes.assign(names.size(), std::vector<Value>(static_cast<std::size_t>(width)));
  }

  // A y stride of 0 makes every row of the file go through the same memory.
  Imf::FrameBuffer& insert(Imf::FrameBuffer& buffer, Imf::PixelType type) {
    for (std::size_t i = 0; i < names.size(); ++i) {
      buffer.insert(names[i], Imf::Slice(type, reinterpret_cast<char*>(planes[i].data()), sizeof(Value), 0));
    }
    return buffer;
  }
};

std::vector<std::string> light_names() { return {"R", "G", "B", "error.R", "error.G", "error.B"}; }

std::vector<std::string> sum_names() {
  std::vector<std::string> names;
  for (const char* channel : channel_names) {
    for (std::size_t i = 0; i < halves; ++i) {
      names.push_back(std::string(channel) + "." + (i < 10 ? "0" : "") + std::to_string(i));
    }
  }
  return names;
}

Imf::Header part_header(const char* name, const Film& film) {
  Imf::Header header(film.width(), film.height());
  header.setName(name);
  header.setType(Imf::SCANLINEIMAGE);
  header.compression() = Imf::ZIP_COMPRESSION;
  return header;
}

std::vector<Imf::Header> headers(const Picture& picture) {
  Imf::Header light = part_header("light", picture.film);
  const auto attribute = [&](const char* name, const std::string& value) {
    light.insert(std::string("fairlight.") + name, Imf::StringAttribute(value));
  };
  attribute("scene", picture.settings.scene);
  attribute("settings", nlohmann::json(picture.settings).dump());
  attribute("seed", picture.samples.json().dump());
  attribute("version", version);
  attribute("checksum", seed_text(picture.checksum()));
  for (const std::string& name : light_names()) light.channels().insert(name, Imf::Channel(Imf::FLOAT));
  light.channels().insert("samples.N", Imf::Channel(Imf::UINT));
  Imf::Header sums = part_header("sums", picture.film);
  for (const std::string& name : sum_names()) sums.channels().insert(name, Imf::Channel(Imf::UINT));
  return {light, sums};
}

// Of a pixel: the film counts sets.
std::uint32_t sample_count(const Film::Pixel& pixel, std::uint32_t points) {
  if (pixel[0].count() > std::numeric_limits<std::uint32_t>::max() / points) {
    throw std::runtime_error("a pixel holds more than 2^32 - 1 samples (the EXR's samples layer cannot say so)");
  }
  return static_cast<std::uint32_t>(pixel[0].count()) * points;
}

void write_light(Imf::MultiPartOutputFile& file, const Film& film, std::uint32_t points) {
  Row<float> row(light_names(), film.width());
  Row<std::uint32_t> counts({"samples.N"}, film.width());
  Imf::FrameBuffer buffer;
  row.insert(buffer, Imf::FLOAT);
  counts.insert(buffer, Imf::UINT);
  Imf::OutputPart part(file, 0);
  part.setFrameBuffer(buffer);
  for (int y = 0; y < film.height(); ++y) {
    for (int x = 0; x < film.width(); ++x) {
      const Film::Pixel& pixel = film.at(x, y);
      const auto column = static_cast<std::size_t>(x);
      for (std::size_t c = 0; c < 3; ++c) {
        row.planes[c][column] = static_cast<float>(pixel[c].mean());
        row.planes[3 + c][column] = static_cast<float>(pixel[c].standard_error());
      }
      counts.planes[0][column] = sample_count(pixel, points);
    }
    part.writePixels(1);
  }
}

void write_sums(Imf::MultiPartOutputFile& file, const Film& film) {
  Row<std::uint32_t> row(sum_names(), film.width());
  Imf::FrameBuffer buffer;
  Imf::OutputPart part(file, 1);
  part.setFrameBuffer(row.insert(buffer, Imf::UINT));
  for (int y = 0; y < film.height(); ++y) {
    for (int x = 0; x < film.width(); ++x) {
      for (std::size_t i = 0; i < row.planes.size(); ++i) {
        const std::uint64_t word = film.at(x, y)[i / halves].words()[i % halves / 2];
        row.planes[i][static_cast<std::size_t>(x)] = static_cast<std::uint32_t>(word >> (i % 2 * 32));
      }
    }
    part.writePixels(1);
  }
}

void read_sums(Imf::MultiPartInputFile& file, Film& film) {
  Row<std::uint32_t> row(sum_names(), film.width());
  Imf::FrameBuffer buffer;
  Imf::InputPart part(file, 1);
  part.setFrameBuffer(row.insert(buffer, Imf::UINT));
  for (int y = 0; y < film.height(); ++y) {
    part.readPixels(y);
    for (int x = 0; x < film.width(); ++x) {
      for (std::size_t c = 0; c < 3; ++c) {
        ExactMoments::Words words{};
        for (std::size_t i = 0; i < halves; ++i) {
          words[i / 2] |= std::uint64_t{row.planes[c * halves + i][static_cast<std::size_t>(x)]} << (i % 2 * 32);
        }
        film.at(x, y)[c] = ExactMoments(words);
      }
    }
  }
}

// Of a file that fairlight wrote and that cannot be used: it follows the file's name.
struct Unusable : std::runtime_error {
  using std::runtime_error::runtime_error;
};

void require_unchanged(bool unchanged) {
  if (!unchanged) throw Unusable("was changed by another program (give the file as fairlight wrote it)");
}

std::string attribute(const Imf::Header& header, const char* name) {
  return header.typedAttribute<Imf::StringAttribute>(std::string("fairlight.") + name).value();
}

bool has_sums(const Imf::Header& header, const RenderSettings& settings) {
  std::vector<std::string> names = sum_names(), found;
  std::sort(names.begin(), names.end());
  for (auto i = header.channels().begin(); i != header.channels().end(); ++i) found.emplace_back(i.name());
  return found == names && header.dataWindow() == Imath::Box2i({0, 0}, {settings.width - 1, settings.height - 1});
}

// What the ledger says was sampled is what every pixel has counted.
void check_counts(const Picture& picture) {
  const std::uint64_t total = picture.samples.total();
  const std::uint32_t points = SampleSets(picture.settings.points).size();
  for (int y = 0; y < picture.film.height(); ++y) {
    for (int x = 0; x < picture.film.width(); ++x) {
      for (const ExactMoments& moments : picture.film.at(x, y)) {
        if (moments.count() != total / points || total % points != 0 || total == 0)
          throw std::runtime_error("its sums do not belong to its samples");
      }
    }
  }
}

Picture read_parts(Imf::MultiPartInputFile& file) {
  const Imf::Header& light = file.header(0);
  const auto settings = nlohmann::json::parse(attribute(light, "settings")).get<RenderSettings>();
  if (light.findTypedAttribute<Imf::StringAttribute>("fairlight.checksum") == nullptr)
    throw Unusable("has no checksum, as of an earlier version of fairlight (render it again)");
  require_unchanged(file.parts() == 2 && settings.scene == attribute(light, "scene") &&
                    has_sums(file.header(1), settings));
  Picture picture{settings, SampleLedger::from_json(nlohmann::json::parse(attribute(light, "seed"))),
                  Film(settings.width, settings.height)};
  read_sums(file, picture.film);
  require_unchanged(seed_text(picture.checksum()) == attribute(light, "checksum"));
  check_counts(picture);
  return picture;
}

}  // namespace

void write_exr(const std::string& path, const Picture& picture) {
  AtomicFile output(path);
  {
    ExrStream stream(output, path);
    const std::vector<Imf::Header> parts = headers(picture);
    Imf::MultiPartOutputFile file(stream, parts.data(), static_cast<int>(parts.size()));
    write_light(file, picture.film, picture.settings.points);
    write_sums(file, picture.film);
  }
  output.commit();
}

void write_exr(const std::string& path, int width, int height, const std::vector<Plane>& planes) {
  Imf::Header header(width, height);
  Imf::FrameBuffer buffer;
  const std::size_t row = sizeof(float) * static_cast<std::size_t>(width);
  for (const Plane& plane : planes) {
    if (plane.values.size() * sizeof(float) != row * static_cast<std::size_t>(height)) {
      throw std::invalid_argument("the plane \"" + plane.name + "\" must have one value a pixel");
    }
    header.channels().insert(plane.name, Imf::Channel(Imf::FLOAT));
    auto* first =
        const_cast<float*>(plane.values.data());  // a slice is read from here, though its type could be written to
    buffer.insert(plane.name, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(first), sizeof(float), row));
  }
  AtomicFile output(path);
  {
    ExrStream stream(output, path);
    Imf::OutputFile file(stream, header);
    file.setFrameBuffer(buffer);
    file.writePixels(height);
  }
  output.commit();
}

Picture read_exr(const std::string& path) {
  if (!std::filesystem::is_regular_file(path)) throw std::runtime_error("there is no file \"" + path + "\"");
  try {
    Imf::MultiPartInputFile file(path.c_str());
    return read_parts(file);
  } catch (const Unusable& problem) {
    throw std::runtime_error("\"" + path + "\" " + problem.what());
  } catch (const std::exception& error) {
    throw std::runtime_error("\"" + path + "\" is not a whole EXR file from fairlight render (" + error.what() +
                             ")");
  }
}

}  // namespace fairlight
