// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/volume/VolumeDocument.h"
#include "tools/ToolKey.h"
#include "tools/carving/VolumeTool.h"
#include "tools/volume/ReshapeOperations.h"

#include <functional>
#include <vector>

namespace handwheel {

// A body that a volume can be combined with.
struct OtherBody {
  std::string key;   // the same for as long as it is offered, and no other's
  std::string name;  // of its document or file; UTF-8
  // Its material, best in the grid of the other. Any thread.
  std::function<Result<SparseVolume>(const SparseVolume& grid, Progress)> material;
};

// What the owner of the jobs does for the tool. All of it is called on the window thread.
struct ReshapeServices {
  struct Job {
    const char* name;  // English, context "Tool"
    std::function<std::function<void()>(Progress)> work;
  };
  // Starts a job in place of the previous one; its result reaches the tool by way of ToolRunner::deliver(). A job that
  // is cancelled calls stopped instead.
  std::function<void(Job, std::function<void()> stopped)> run;
  std::function<void()> cancel;
  std::function<std::vector<OtherBody>()> bodies;  // what there is to be combined with at present
  std::function<void()> addFile;                   // lets a person choose a file that becomes one of them
  std::function<void(const Error&)> failed;
};

// Tool that changes a volume as a whole: shell, moved surface, boolean, debris, gaps, smoothing. What would come of it
// is computed as a job and shown in place of the volume until it is committed as one step.
class ReshapeTool : public Tool {
 public:
  enum class Change { Shell, Offset, Boolean, Debris, Gaps, Smooth };
  static constexpr int kChanges = 6;
  static const Operation& operation(Change change);

  // The document must outlive all calls but the destructor's.
  ReshapeTool(VolumeDocument& document, ReshapeServices services, Change change);

  static std::span<const ToolKey> keys();
  std::string id() const override { return "reshape"; }
  ToolReply pointer(const PointerEvent&) override { return ToolReply::Ignored; }
  ToolReply perform(std::string_view action) override;
  ToolReply undo() override;
  std::vector<ToolAction> actions() const override;
  ToolPreview preview() const override;
  std::vector<Property> settings() const override;
  void setSetting(std::string_view id, const PropertyValue& value) override;
  bool remembersSettings() const override { return false; }
  void documentChanged() override;

 private:
  // What a job has made.
  struct Made {
    std::shared_ptr<const VolumePreview> shown;
    std::shared_ptr<const DisplayPart> gone;  // of debris; null: nothing
    std::size_t kept = 0, parts = 0;          // of debris
  };

  OperationValues& values() { return m_values[static_cast<std::size_t>(m_change)]; }
  const OperationValues& values() const { return m_values[static_cast<std::size_t>(m_change)]; }
  void chooseUsual();
  void chooseBody(const PropertyValue& value);
  void propose();
  void drop();
  void take(std::uint64_t request, const Result<Made>& made, std::shared_ptr<const VolumeParts> parts);
  void commit();
  const char* obstacle() const;
  const char* needless() const;

  VolumeDocument& m_document;
  ReshapeServices m_services;
  Change m_change;
  std::vector<OperationValues> m_values;  // of each change
  std::vector<OtherBody> m_bodies;        // as the settings show them
  std::size_t m_body = 0;
  std::optional<Made> m_made;                                          // of the present settings
  std::shared_ptr<const VolumeParts> m_parts;                          // of the volume as it is; null: not known
  std::uint64_t m_request = 0;                                         // the last one
  std::shared_ptr<const int> m_alive = std::make_shared<const int>();  // until the tool goes: a result comes later
  bool m_isWorking = false;
  bool m_isProposing = true;  // what the settings say is computed without being asked for
  bool m_isToCommit = false;  // as soon as it is made
};

}  // namespace handwheel
