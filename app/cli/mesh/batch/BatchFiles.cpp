// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mesh/batch/BatchFiles.h"

#include "cli/Input.h"
#include "cli/Interrupt.h"
#include "document/mesh/MeshKind.h"

#include <sys/stat.h>
#include <algorithm>
#include <map>

namespace handwheel {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMostFiles = 1000000;

using Endings = std::set<std::string>;  // lower case with the point

// Endings for files that are repaired into others of their format.
Endings meshEndings(const DocumentKinds& kinds) {
  Endings endings;
  if (const DocumentKind* kind = kinds.withId(kMeshKind)) {
    for (const FileFormat& format : kind->formats()) {
      if (format.reads && format.writes) endings.insert(format.endings.begin(), format.endings.end());
    }
  }
  return endings;
}

bool hasEnding(const fs::path& path, const Endings& endings) {
  std::string ending = path.extension().string();
  for (char& c : ending) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  return endings.contains(ending);
}

// Whole, and without "." and "..": by it a file named twice is known.
fs::path wholePath(const fs::path& path) {
  std::error_code ignored;
  return fs::absolute(path, ignored).lexically_normal();
}

class Planner {
 public:
  Planner(fs::path output, std::string_view ending, Endings endings)
      : m_output(std::move(output)), m_ending(ending), m_endings(std::move(endings)) {}

  void addOperand(const fs::path& operand) {
    std::error_code ignored;
    if (fs::is_directory(operand, ignored)) return addFolder(operand);
    const fs::path name = operand.has_filename() ? operand.filename() : operand.parent_path().filename();
    add(operand, name, {});
  }

  // Problems are looked for last, so that the same are found whatever comes first.
  BatchPlan finish() {
    noteInputs();
    if (m_plan.files.size() > kMostFiles) {
      m_plan.problem = "There are more than " + std::to_string(kMostFiles) + " files; repair them in several runs.";
      return std::move(m_plan);
    }
    std::map<fs::path, const BatchFile*> taken;
    for (const BatchFile& file : m_plan.files) {
      if (!file.problem.empty()) continue;
      const auto [first, isNew] = taken.emplace(file.output.lexically_normal(), &file);
      if (!isNew) {
        m_plan.problem = first->second->input.string() + " and " + file.input.string() + " would both be written to " +
                         file.output.string() + ". Repair them into different folders.";
      } else if (m_plan.isInput(file.output)) {
        m_plan.problem = file.output.string() + " is an input; many files are repaired into another folder.";
      }
      if (!m_plan.problem.empty()) break;
    }
    return std::move(m_plan);
  }

 private:
  void add(const fs::path& input, fs::path relative, std::string problem) {
    if (m_plan.files.size() > kMostFiles || !m_known.insert(wholePath(input)).second) return;
    if (!m_ending.empty()) relative.replace_extension(m_ending);
    m_plan.files.push_back({input, m_output / relative, std::move(problem)});
  }

  void addFolder(const fs::path& root) {
    std::vector<std::pair<fs::path, std::string>> found;  // below the root; a problem where it is a folder with one
    std::vector<fs::path> folders{{}};
    while (!folders.empty() && found.size() <= kMostFiles && !wasInterrupted()) {
      const fs::path folder = std::move(folders.back());
      folders.pop_back();
      list(root, folder, folders, found);
    }
    std::sort(found.begin(), found.end());
    for (auto& [relative, problem] : found) add(root / relative, relative, std::move(problem));
  }

  // The files of one folder below the root, and the folders in it.
  void list(const fs::path& root, const fs::path& folder, std::vector<fs::path>& folders,
            std::vector<std::pair<fs::path, std::string>>& found) const {
    std::error_code error, ignored;
    fs::directory_iterator entry(folder.empty() ? root : root / folder, error);
    for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
      const fs::path name = entry->path().filename();
      if (name.native().starts_with('.')) continue;
      if (entry->is_directory(ignored)) {
        const bool isLeftOut = entry->is_symlink(ignored) || fs::equivalent(entry->path(), m_output, ignored);
        if (!isLeftOut) folders.push_back(folder / name);
      } else if (hasEnding(name, m_endings) && entry->is_regular_file(ignored)) {
        found.emplace_back(folder / name, std::string());
      } else if (hasEnding(name, m_endings) && entry->is_symlink(ignored) && !entry->exists(ignored)) {
        found.emplace_back(folder / name, "The target of the link does not exist.");
      }
    }
    if (error) found.emplace_back(folder, "The folder cannot be read (" + error.message() + ").");
  }

  void noteInputs() {
    for (const BatchFile& file : m_plan.files) {
      struct stat is {};
      if (::stat(file.input.c_str(), &is) == 0) m_plan.inputIds.emplace(is.st_dev, is.st_ino);
    }
  }

  fs::path m_output;
  std::string m_ending;
  Endings m_endings;
  std::set<fs::path> m_known;
  BatchPlan m_plan;
};

}  // namespace

bool BatchPlan::isInput(const fs::path& path) const {
  struct stat is {};
  return ::stat(path.c_str(), &is) == 0 && inputIds.contains({is.st_dev, is.st_ino});
}

BatchPlan planBatch(const std::vector<std::string>& operands, const fs::path& output, std::string_view ending,
                    const DocumentKinds& kinds) {
  Planner planner(output, ending, meshEndings(kinds));
  for (const std::string& operand : operands) planner.addOperand(operand);
  return planner.finish();
}

}  // namespace handwheel
