// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

// Stands in for libFuzzer: changes seed files at random for some seconds and hands them to the entry.
//   MeshReaderFuzz SECONDS RANDOM-SEED FOLDER [PATIENCE]
// FOLDER holds the seeds; words that the format knows are in FOLDER.dict, as libFuzzer writes them. The input under
// test is kept in a file named after the program, so that it is there after a crash. An input that takes longer than
// PATIENCE seconds, or five, of the processor is reported as a failure; what else the machine does is not its fault.

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

using Bytes = std::vector<std::uint8_t>;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kLongestSeed = 200000;  // bytes; larger files only make it slow

Bytes contentOf(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return Bytes(std::istreambuf_iterator<char>(stream), {});
}

std::vector<Bytes> readSeeds(const std::filesystem::path& folder) {
  std::vector<Bytes> seeds;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && entry.file_size() <= kLongestSeed) seeds.push_back(contentOf(entry.path()));
  return seeds;
}

// The word between the quotes of a line: \\, \" and \xNN stand for a byte.
Bytes unquoted(const std::string& line) {
  Bytes word;
  for (std::size_t i = line.find('"') + 1; i < line.size() && line[i] != '"'; ++i) {
    if (line[i] == '\\' && line[++i] == 'x') {
      word.push_back(static_cast<std::uint8_t>(std::stoul(line.substr(i + 1, 2), nullptr, 16)));
      i += 2;
    } else {
      word.push_back(static_cast<std::uint8_t>(line[i]));
    }
  }
  return word;
}

std::vector<Bytes> readWords(const std::filesystem::path& dictionary) {
  std::vector<Bytes> words = {{'0'}, {'-', '1'}, {'n', 'a', 'n'}};
  std::ifstream stream(dictionary);
  for (std::string line; std::getline(stream, line);)
    if (line.starts_with('"')) words.push_back(unquoted(line));
  return words;
}

class Mutator {
 public:
  Mutator(std::vector<Bytes> seeds, std::vector<Bytes> words, std::uint32_t randomSeed)
      : m_seeds(std::move(seeds)), m_words(std::move(words)), m_random(randomSeed) {}

  Bytes mutated() {
    Bytes bytes = m_seeds[below(m_seeds.size())];
    if (bytes.size() > 4096 && below(4) != 0) shorten(bytes);
    for (std::size_t i = below(8); i > 0 && !bytes.empty(); --i) change(bytes);
    return bytes;
  }

 private:
  std::size_t below(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(m_random); }

  // Keeps the head, which controls the reader, and some of the rest.
  void shorten(Bytes& bytes) { bytes.resize(below(4096)); }

  void change(Bytes& bytes) {
    const std::size_t at = below(bytes.size());
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
        insert(bytes, at, m_words[below(m_words.size())]);
        break;
      case 5: {  // a piece of this or another file
        const Bytes& other = m_seeds[below(m_seeds.size())];
        const std::size_t from = below(other.size() + 1), length = std::min(other.size() - from, below(64));
        const auto begin = other.begin() + static_cast<std::ptrdiff_t>(from);
        insert(bytes, at, Bytes(begin, begin + static_cast<std::ptrdiff_t>(length)));
        break;
      }
      default:  // a number of four bytes at its limits
        std::fill_n(here, most(4), static_cast<std::uint8_t>(below(2) * 255));
    }
  }

  static void insert(Bytes& bytes, std::size_t at, const Bytes& piece) {
    bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(at), piece.begin(), piece.end());
  }

  std::vector<Bytes> m_seeds;
  std::vector<Bytes> m_words;
  std::mt19937 m_random;
};

void keep(const Bytes& bytes, const std::string& file) {
  std::ofstream stream(file, std::ios::binary | std::ios::trunc);
  stream.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

}  // namespace

int main(int argc, char** argv) {
  const std::string name = std::filesystem::path(argv[0]).filename().string();
  if (argc != 4 && argc != 5) {
    std::fprintf(stderr, "usage: %s SECONDS RANDOM-SEED FOLDER [PATIENCE]\n", name.c_str());
    return 2;
  }
  const auto end = Clock::now() + std::chrono::seconds(std::atoi(argv[1]));
  const double patience = argc == 5 ? std::atof(argv[4]) : 5.0;  // s
  const std::filesystem::path folder = argv[3];
  std::vector<Bytes> seeds = readSeeds(folder);
  if (seeds.empty()) {
    std::fprintf(stderr, "%s: there are no seeds in %s\n", name.c_str(), argv[3]);
    return 2;
  }
  Mutator mutator(std::move(seeds), readWords(folder.string() + ".dict"),
                  static_cast<std::uint32_t>(std::strtoul(argv[2], nullptr, 10)));
  std::size_t runs = 0;
  for (; Clock::now() < end; ++runs) {
    const Bytes bytes = mutator.mutated();
    keep(bytes, name + "-input");
    const std::clock_t start = std::clock();
    LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
    if (static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC > patience) {
      std::fprintf(stderr, "%s: an input took too long\n", name.c_str());
      return 1;
    }
  }
  std::printf("%zu inputs\n", runs);
  return 0;
}
