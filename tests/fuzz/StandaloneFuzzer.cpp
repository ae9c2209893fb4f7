// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

// Stands in for libFuzzer: changes seed files at random for some seconds and hands them to the entry.
//   MeshReaderFuzz SECONDS RANDOM-SEED SEED-FILE-OR-FOLDER...
// The input under test is kept in the file "fuzz-input", so that it is there after a crash. An input that takes longer
// than five seconds is reported as a failure.

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

using Bytes = std::vector<std::uint8_t>;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kLongestSeed = 200000;  // bytes; larger files only make it slow

void addSeed(std::vector<Bytes>& seeds, const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  Bytes bytes((std::istreambuf_iterator<char>(stream)), {});
  bytes.insert(bytes.begin(), 0);
  if (bytes.size() <= kLongestSeed) seeds.push_back(std::move(bytes));
}

class Mutator {
 public:
  explicit Mutator(std::uint32_t seed) : m_random(seed) {}

  Bytes mutated(const std::vector<Bytes>& seeds) {
    Bytes bytes = seeds[below(seeds.size())];
    bytes[0] = static_cast<std::uint8_t>(m_random());
    if (bytes.size() > 4096 && below(4) != 0) shorten(bytes);
    for (std::size_t i = below(8); i > 0 && bytes.size() > 1; --i) change(bytes, seeds);
    return bytes;
  }

 private:
  std::size_t below(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(m_random); }
  std::size_t place(const Bytes& bytes) { return 1 + below(bytes.size() - 1); }

  // Keeps the head, which steers the reader, and some of the rest.
  void shorten(Bytes& bytes) { bytes.resize(1 + below(4096)); }

  void change(Bytes& bytes, const std::vector<Bytes>& seeds) {
    const std::size_t at = place(bytes);
    const auto here = bytes.begin() + static_cast<std::ptrdiff_t>(at);
    const auto most = [&](std::size_t n) { return static_cast<std::ptrdiff_t>(std::min(n, bytes.size() - at)); };
    switch (below(7)) {
      case 0:
        bytes[at] ^= static_cast<std::uint8_t>(1u << below(8));
        break;
      case 1:
        bytes[at] = static_cast<std::uint8_t>(m_random());
        break;
      case 2:
        bytes.erase(here, here + most(1 + below(16)));
        break;
      case 3:
        bytes.resize(at);
        break;
      case 4:
        insertWord(bytes, at);
        break;
      case 5: {  // a piece of this or another file
        const Bytes& other = seeds[below(seeds.size())];
        const std::size_t from = below(other.size()), length = std::min(other.size() - from, below(64));
        const Bytes piece(other.begin() + static_cast<std::ptrdiff_t>(from),
                          other.begin() + static_cast<std::ptrdiff_t>(from + length));
        bytes.insert(here, piece.begin(), piece.end());
        break;
      }
      default:  // a number of four bytes at its limits
        std::fill_n(here, most(4), static_cast<std::uint8_t>(below(2) * 255));
    }
  }

  void insertWord(Bytes& bytes, std::size_t at) {
    static const std::string kWords[] = {"nan",
                                         "inf",
                                         "1e309",
                                         "-1",
                                         "0",
                                         "4294967295",
                                         "2147483648",
                                         "99999999999999999999",
                                         "\\\n",
                                         "\r",
                                         "\n",
                                         "#",
                                         "end_header\n",
                                         "element face 9\n",
                                         "property list char char a\n",
                                         "vertex ",
                                         "endloop ",
                                         "endfacet\n",
                                         "solid ",
                                         "facet normal ",
                                         "f ",
                                         "v ",
                                         "/",
                                         "OFF ",
                                         "BINARY\n",
                                         "-"};
    const std::string& word = kWords[below(std::size(kWords))];
    bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(at), word.begin(), word.end());
  }

  std::mt19937 m_random;
};

void keep(const Bytes& bytes) {
  std::ofstream stream("fuzz-input", std::ios::binary | std::ios::trunc);
  stream.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) {
    std::fprintf(stderr, "usage: MeshReaderFuzz SECONDS RANDOM-SEED SEED-FILE-OR-FOLDER...\n");
    return 2;
  }
  const auto end = Clock::now() + std::chrono::seconds(std::atoi(argv[1]));
  std::vector<Bytes> seeds;
  for (int i = 3; i < argc; ++i) {
    if (!std::filesystem::is_directory(argv[i])) {
      addSeed(seeds, argv[i]);
      continue;
    }
    for (const auto& entry : std::filesystem::recursive_directory_iterator(argv[i]))
      if (entry.is_regular_file()) addSeed(seeds, entry.path());
  }
  if (seeds.empty()) return 2;
  Mutator mutator(static_cast<std::uint32_t>(std::strtoul(argv[2], nullptr, 10)));
  std::size_t runs = 0;
  for (; Clock::now() < end; ++runs) {
    const Bytes bytes = mutator.mutated(seeds);
    keep(bytes);
    const auto start = Clock::now();
    LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
    if (Clock::now() - start > std::chrono::seconds(5)) {
      std::fprintf(stderr, "MeshReaderFuzz: an input took too long\n");
      return 1;
    }
  }
  std::printf("%zu inputs from %zu seeds\n", runs, seeds.size());
  return 0;
}
