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

// A body with which a volume can be combined.
struct OtherBody {
  std::string key;   // unique, and constant while the body is offered
  std::string name;  // name of the body's document or file, UTF-8
  // Function that returns the material of the body, preferably in this grid. It may be called on any thread.
  std::function<Result<SparseVolume>(const SparseVolume& grid, Progress)> material;
};

// The services that the window provides for the tool. All are called on the window thread.
struct ReshapeServices {
  struct Job {
    const char* name;  // English text, translated in the context "Tool"
    std::function<std::function<void()>(Progress)> work;
  };
  // Function that starts a job and cancels the previous one. The result of the job reaches the tool through
  // ToolRunner::deliver(); if the job is cancelled, `stopped` is called instead.
  std::function<void(Job, std::function<void()> stopped)> run;
  std::function<void()> cancel;
  std::function<std::vector<OtherBody>()> bodies;  // returns the bodies with which the volume can currently be combined
  std::function<void()> addFile;                   // lets the user choose a file that is added to the bodies
  std::function<void(const Error&)> failed;
};

// Tool that changes a volume as a whole: shell, offset, boolean, debris, gaps, smoothing. A job computes the result,
// which is shown instead of the volume until it is committed as one step.
class ReshapeTool : public Tool {
 public:
  enum class Change { Shell, Offset, Boolean, Debris, Gaps, Smooth };
  static constexpr int kChanges = 6;
  static const Operation& operation(Change change);

  // The document must outlive all calls except that of the destructor.
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
  // The result of a job.
  struct Made {
    std::shared_ptr<const VolumePreview> shown;
    std::shared_ptr<const DisplayPart> gone;  // removed debris; null: none
    std::size_t kept = 0, parts = 0;          // number of kept parts and of all parts, for debris
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
  std::vector<OperationValues> m_values;  // values of each change
  std::vector<OtherBody> m_bodies;        // bodies in the order of the setting
  std::size_t m_body = 0;
  std::optional<Made> m_made;                  // result for the current settings
  std::shared_ptr<const VolumeParts> m_parts;  // parts of the current volume; null: unknown
  std::uint64_t m_request = 0;                 // number of the last request
  std::shared_ptr<const int> m_alive =
      std::make_shared<const int>();  // expires with the tool, for results that arrive after its destruction
  bool m_isWorking = false;
  bool m_isProposing = true;  // true if results for the settings are computed automatically
  bool m_isToCommit = false;  // true if the result is committed as soon as it is available
};

}  // namespace handwheel
