// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DocumentKind.h"
#include "document/exercise/ExerciseSnapshot.h"

namespace handwheel {

// Document kind of exercises, students' copies of them and what was handed in.
class ExerciseKind : public DocumentKind {
 public:
  // subjects: what exercises can be about, at least one; the first is that of new exercises.
  explicit ExerciseKind(std::vector<std::unique_ptr<ExerciseSubject>> subjects);

  std::span<const std::unique_ptr<ExerciseSubject>> subjects() const { return m_subjects; }

  std::string id() const override { return "exercise"; }
  std::string title() const override;
  // Descriptions in JSON.
  std::vector<FileFormat> formats() const override;
  bool recognises(std::string_view head, std::string_view name) const override;
  Result<OpenedFile> import(const std::filesystem::path& path, const ReadOptions& options,
                            Progress progress) const override;
  Result<WrittenFile> exportTo(const Snapshot& content, const std::filesystem::path& path,
                               Progress progress) const override;
  void save(const Snapshot& content, Container& container) const override;
  // Error besides those of damage: SubjectUnknown {subject}.
  Result<SnapshotPointer> load(const Container& container, std::vector<Error>& damage,
                               Progress progress) const override;
  SnapshotPointer blank() const override { return blankOf(*m_subjects.front()); }
  // A new exercise about one of the subjects.
  SnapshotPointer blankOf(const ExerciseSubject& subject) const;
  std::unique_ptr<Document> make(OpenedFile opened) const override;
  nlohmann::json describe(const Snapshot& content) const override;
  // The work, where there is some, or the target.
  DisplayModel display(const Snapshot& content) const override;

  // An exercise from a description: the JSON of the document, with the model solution as the subject describes work. A
  // description that is "for_students" gives a copy for them.
  // Errors: SubjectUnknown, those of damage, of which a description must have none; ElementMalformed, Cancelled.
  Result<SnapshotPointer> fromDescription(const nlohmann::json& description, Progress progress) const;
  // Such a description, without solution, attempt and work. One without a key gets the same at each reading.
  static nlohmann::json description(const ExerciseSnapshot& exercise);

 private:
  Result<ExerciseSnapshot> read(const nlohmann::json& document, std::vector<Error>& damage) const;

  std::vector<std::unique_ptr<ExerciseSubject>> m_subjects;
};

// A new key for an exercise: a UUID.
std::string newExerciseKey();

}  // namespace handwheel
