// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Container.h"

#include <nlohmann/json.hpp>
#include <random>

// The document of the crash test, which a child process edits and the parent checks.
namespace handwheel::test {

// A model whose content after any number of edits is known. It has a counter of the edits, and blobs, each with its
// content after the last edit that changed it.
class CrashModel {
 public:
  CrashModel() : m_blobs(kBlobs) {}

  std::uint64_t edits() const { return m_edits; }

  void edit() {
    ++m_edits;
    m_blobs[m_edits % kBlobs] = blobAfter(m_edits);
  }

  std::string archive(Compression compression) const {
    Container container;
    *container.manifest = {{"kind", "crash"}, {"document", {{"edits", m_edits}}}};
    for (std::size_t i = 0; i < kBlobs; ++i) container.blobs["crash/" + std::to_string(i)] = m_blobs[i];
    return *writeContainer(container, compression);
  }

  // Returns the number of edits in an archive; -1 if the archive is damaged, or its content differs from that of
  // the model after this number of edits.
  static std::int64_t editsIn(std::string_view bytes) {
    const auto read = readContainer(bytes);
    if (!read || !read->damage.empty() || read->container.blobs.size() != kBlobs) return -1;
    const auto edits = (*read->container.manifest)["document"].value("edits", std::uint64_t{0});
    for (std::size_t i = 0; i < kBlobs; ++i) {
      std::uint64_t last = edits;  // the last edit of blob i
      while (last > 0 && last % kBlobs != i) --last;
      if (read->container.blobs.at("crash/" + std::to_string(i)) != (last > 0 ? blobAfter(last) : "")) return -1;
    }
    return static_cast<std::int64_t>(edits);
  }

 private:
  static constexpr std::size_t kBlobs = 20;

  static std::string blobAfter(std::uint64_t edit) {
    std::mt19937_64 random(edit);
    std::string blob(random() % 60'000, '\0');
    for (char& c : blob) c = static_cast<char>(random());
    return blob;
  }

  std::uint64_t m_edits = 0;
  std::vector<std::string> m_blobs;
};

}  // namespace handwheel::test
