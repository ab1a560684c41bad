#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>
#include <support/program.h>

#include <fairlight/render/instruction_sets.h>

// The program starts on every x86-64: what runs before a kernel is chosen needs nothing beyond SSE2.
namespace fairlight {
namespace {

using testing::read_file;
using testing::Result;
using testing::TemporaryFolder;

#if defined(__x86_64__) && !defined(__AVX__)

void for_each_line(const std::string& command, const std::function<void(std::string_view)>& use) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  ASSERT_NE(pipe, nullptr) << command;
  char* line = nullptr;  // a demangled name has no largest length
  std::size_t size = 0;
  while (getline(&line, &size, pipe.get()) >= 0) use(line);
  std::free(line);
}

// Mnemonics that SSE3 to SSE4.2 and the bit manipulations brought, by their beginnings. AVX's begin with v. That of
// tzcnt is left out: older processors take it for bsf, which is the same where the compiler uses it.
bool is_beyond_sse2(std::string_view mnemonic, std::string_view operands) {
  static const std::vector<std::string> beginnings{
      "addsub",  "haddp",     "hsubp",    "lddqu",    "movddup", "movsh",    "movsld",  "fisttp", "pabs",
      "palignr", "phadd",     "phsub",    "pmaddub",  "pmulhrs", "pshufb",   "psign",   "blend",  "pblend",
      "dpp",     "extractps", "insertps", "movntdqa", "mpsadbw", "packusdw", "pcmpeqq", "pextrb", "pextrd",
      "pextrq",  "phmin",     "pinsrb",   "pinsrd",   "pinsrq",  "pmaxsb",   "pmaxsd",  "pmaxud", "pmaxuw",
      "pminsb",  "pminsd",    "pminud",   "pminuw",   "pmovsx",  "pmovzx",   "pmuldq",  "pmulld", "ptest",
      "round",   "crc32",     "pcmpestr", "pcmpistr", "pcmpgtq", "popcnt",   "lzcnt",   "andn ",  "bextr",
      "bls",     "bzhi",      "mulx",     "pdep ",    "pext ",   "rorx",     "sarx",    "shlx",   "shrx",
      "adcx",    "adox",      "movbe",    "aes",      "pclmul",  "sha1",     "sha256"};
  if (mnemonic.starts_with("v") && !mnemonic.starts_with("ver")) return true;
  if (operands.find("%ymm") != std::string_view::npos || operands.find("%zmm") != std::string_view::npos)
    return true;
  const std::string word = std::string(mnemonic) + " ";
  return std::ranges::any_of(beginnings, [&](const std::string& each) { return word.starts_with(each); });
}

struct Section {
  std::string name;
  std::uint64_t begin, end;
  bool is_code;
  bool holds(std::uint64_t address) const { return address >= begin && address < end; }
  bool is_kernel() const { return name.starts_with("fairlight_"); }
};

std::vector<Section> sections() {
  std::vector<Section> all;
  for_each_line("objdump -h -w " FAIRLIGHT_PROGRAM, [&](std::string_view text) {
    std::istringstream line{std::string(text)};
    int index = 0;
    std::string name, size, address;
    if (line >> index >> name >> size >> address) {
      const std::uint64_t begin = std::stoull(address, nullptr, 16);
      all.push_back(
          {name, begin, begin + std::stoull(size, nullptr, 16), text.find("CODE") != std::string_view::npos});
    }
  });
  return all;
}

// Instructions beyond SSE2, by function, in all code that is not a kernel's.
std::map<std::string, std::string> foreign_instructions(const std::vector<Section>& all) {
  std::map<std::string, std::string> found;
  std::string function;
  for (const Section& section : all) {
    if (!section.is_code || section.is_kernel()) continue;
    for_each_line("objdump -d -C --no-show-raw-insn -j " + section.name + " " FAIRLIGHT_PROGRAM,
                  [&](std::string_view line) {
                    if (line.ends_with(">:\n")) {
                      function = line.substr(std::min(line.find('<'), line.size()));
                      return;
                    }
                    const std::size_t tab = line.find('\t');
                    if (!line.starts_with(" ") || tab == std::string_view::npos) return;
                    const std::string_view instruction = line.substr(tab + 1);
                    const std::size_t end = instruction.find_first_of(" \n");
                    if (is_beyond_sse2(instruction.substr(0, end), instruction.substr(end)))
                      found.emplace(function, instruction);
                  });
  }
  return found;
}

// Where the functions are that run before and after main, as the loader is told to find them.
std::vector<std::uint64_t> start_up_functions(const std::vector<Section>& all) {
  std::vector<std::uint64_t> functions;
  for_each_line("readelf -rW " FAIRLIGHT_PROGRAM, [&](std::string_view text) {
    std::istringstream line{std::string(text)};
    std::string offset, info, type, addend;
    if (!(line >> offset >> info >> type >> addend) || type.find("_RELATIVE") == std::string::npos) return;
    const std::uint64_t place = std::stoull(offset, nullptr, 16);
    for (const Section& section : all) {
      if (!section.holds(place) || (section.name != ".init_array" && section.name != ".fini_array")) continue;
      functions.push_back(std::stoull(addend, nullptr, 16));
    }
  });
  return functions;
}

TEST(StartUp, HasNoInstructionBeyondSse2OutsideOfKernels) {
  const std::vector<Section> all = sections();
  EXPECT_EQ(std::ranges::count_if(all, &Section::is_kernel), 2) << "one of avx2, one of avx512";
  for (const auto& [function, instruction] : foreign_instructions(all)) ADD_FAILURE() << function << instruction;
}

TEST(StartUp, RunsNothingOfAKernel) {
  const std::vector<Section> all = sections();
  const std::vector<std::uint64_t> functions = start_up_functions(all);
  EXPECT_FALSE(functions.empty()) << "there is always frame_dummy";
  for (const std::uint64_t function : functions) {
    for (const Section& section : all) {
      if (!section.is_kernel()) continue;
      EXPECT_FALSE(section.holds(function)) << section.name << " at " << std::hex << function;
    }
  }
}

TEST(StartUp, TellsInstructionsApart) {
  EXPECT_TRUE(is_beyond_sse2("vmovaps", " %xmm0,%xmm1"));
  EXPECT_TRUE(is_beyond_sse2("pmulld", " %xmm0,%xmm1"));
  EXPECT_TRUE(is_beyond_sse2("andn", " %rax,%rbx,%rcx"));
  EXPECT_FALSE(is_beyond_sse2("andnps", " %xmm0,%xmm1"));
  EXPECT_FALSE(is_beyond_sse2("mulpd", " %xmm0,%xmm1"));
  EXPECT_FALSE(is_beyond_sse2("pextrw", " $0x1,%xmm0,%eax"));
  EXPECT_TRUE(is_beyond_sse2("pext", " %rax,%rbx,%rcx"));
  EXPECT_TRUE(is_beyond_sse2("movshdup", " %xmm0,%xmm1"));
}

// An older processor, by an emulator.
struct Processor {
  std::string name;
  std::vector<std::string> sets;
};

std::string picture(const Processor* processor, const std::string& set, const TemporaryFolder& folder) {
  const std::string emulator = processor == nullptr ? "" : "qemu-x86_64 -cpu " + processor->name + " ";
  const Result run = testing::shell(emulator +
                                        FAIRLIGHT_PROGRAM
                                        " render cornell-simple --width 16 --height 16 --spp 4 --seed 7 -o a.exr "
                                        "--instructions " +
                                        set,
                                    folder);
  EXPECT_EQ(run.status, 0) << emulator << set << "\n" << run.error;
  return read_file(folder / "a.exr");
}

class OlderProcessor : public ::testing::TestWithParam<Processor> {};

TEST_P(OlderProcessor, StartsCertifiesAndRenders) {
  const TemporaryFolder folder;
  const auto emulated = [&](const std::string& arguments) {
    return testing::shell("qemu-x86_64 -cpu " + GetParam().name + " " FAIRLIGHT_PROGRAM " " + arguments, folder);
  };
  EXPECT_EQ(emulated("--version").status, 0);
  const Result run = emulated("verify pick.one.dice roulette.integral hemisphere.cosine.moments --margin 0.01");
  EXPECT_EQ(run.status, 0) << run.error << run.out;
  EXPECT_NE(run.out.find("packets of " + GetParam().sets.back() + ","), std::string::npos) << run.out;
  const Result wider = emulated("render cornell-simple --spp 1 --instructions avx512 -o b.exr");
  EXPECT_EQ(wider.status, 2) << "no emulated processor has AVX-512";
}

TEST_P(OlderProcessor, RendersWhatThisMachineRenders) {
  const TemporaryFolder folder;
  for (const InstructionSet& set : instruction_sets()) {
    if (!set.runs_here || std::ranges::find(GetParam().sets, set.name) == GetParam().sets.end()) continue;
    EXPECT_EQ(picture(&GetParam(), set.name, folder), picture(nullptr, set.name, folder)) << set.name;
  }
}

INSTANTIATE_TEST_SUITE_P(StartUp, OlderProcessor,
                         ::testing::Values(Processor{"qemu64", {"sse2"}}, Processor{"Nehalem", {"sse2"}},
                                           Processor{"Haswell", {"sse2", "avx2"}}),
                         [](const auto& processor) { return processor.param.name; });

#endif

}  // namespace
}  // namespace fairlight
