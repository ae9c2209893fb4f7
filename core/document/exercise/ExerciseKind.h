// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DocumentKind.h"
#include "document/exercise/ExerciseSnapshot.h"

namespace handwheel {

// Document kind of exercises, students' copies of them and submissions.
class ExerciseKind : public DocumentKind {
 public:
  // subjects: the subjects that exercises can have, at least one; the first is that of new exercises.
  explicit ExerciseKind(std::vector<std::unique_ptr<ExerciseSubject>> subjects);

  std::span<const std::unique_ptr<ExerciseSubject>> subjects() const { return m_subjects; }

  std::string id() const override { return "exercise"; }
  std::string title() const override;
  // Returns the format of descriptions in JSON.
  std::vector<FileFormat> formats() const override;
  bool recognises(std::string_view head, std::string_view name) const override;
  Result<OpenedFile> import(const std::filesystem::path& path, const ReadOptions& options,
                            Progress progress) const override;
  Result<WrittenFile> exportTo(const Snapshot& content, const std::filesystem::path& path,
                               Progress progress) const override;
  void save(const Snapshot& content, Container& container) const override;
  // Errors besides those of damage: SubjectUnknown {subject}.
  Result<SnapshotPointer> load(const Container& container, std::vector<Error>& damage,
                               Progress progress) const override;
  SnapshotPointer blank() const override { return blankOf(*m_subjects.front()); }
  // Returns a new exercise about one of the subjects.
  SnapshotPointer blankOf(const ExerciseSubject& subject) const;
  std::unique_ptr<Document> make(OpenedFile opened) const override;
  nlohmann::json describe(const Snapshot& content) const override;
  // Returns the display of the work or, if there is none, of the target.
  DisplayModel display(const Snapshot& content) const override;

  // Makes an exercise from a description: the JSON of the document, with the model solution in the subject's own
  // description. A description that is "for_students" gives a copy for them. Errors: SubjectUnknown, ElementMalformed,
  // Cancelled, and any damage.
  Result<SnapshotPointer> fromDescription(const nlohmann::json& description, Progress progress) const;
  // Returns such a description, without solution, attempt and work. A description without a key gets the same key each
  // time it is read.
  static nlohmann::json description(const ExerciseSnapshot& exercise);

 private:
  Result<ExerciseSnapshot> read(const nlohmann::json& document, std::vector<Error>& damage) const;

  std::vector<std::unique_ptr<ExerciseSubject>> m_subjects;
};

// Returns a new key for an exercise: a UUID.
std::string newExerciseKey();

}  // namespace handwheel
