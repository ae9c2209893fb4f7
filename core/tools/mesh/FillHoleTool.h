// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/holes/HoleFiller.h"
#include "mesh/search/FaceHierarchy.h"
#include "tools/ToolKey.h"
#include "tools/mesh/MeshSelection.h"
#include "tools/mesh/boundary/BridgeEditing.h"
#include "tools/mesh/operations/FillOperation.h"

#include <functional>
#include <memory>

namespace handwheel {

class MeshDocument;

// A request for a proposed patch for a hole.
struct FillRequest {
  std::uint64_t ticket = 0;  // returned with the answer
  BoundaryLoop loop;
  std::vector<HoleBridge> bridges = {};  // bridges across the hole, as in FillOptions
};

// Services for FillHoleTool, provided by the owner of the document's jobs. All of them are called on the window thread.
struct FillServices {
  // The values of the fill operation. They are shared with the owner, so that a choice is kept for the next hole and
  // the next start of the tool.
  std::shared_ptr<OperationValues> values = std::make_shared<OperationValues>(fillOperation());
  std::function<std::shared_ptr<const FaceHierarchy>()> faces;  // the service "picking", as in MeshServices
  // The service "fill preview". It proposes a patch and answers by previewReady(), at once or later. A request replaces
  // the previous one.
  std::function<void(const FillRequest&)> request;
  // Adds a proposed patch to the document as one step, at once or later. Returns false if another job is running.
  std::function<bool(const BoundaryLoop&, const FillAttempt&)> commit;
  // Returns true if the patch is shown before it is added.
  std::function<bool()> showsPatch = [] { return true; };
};

// Tool that fills holes one by one, with a preview of the patch. The user chooses a hole, sees the patch, accepts or
// rejects it, and continues with the next hole. A line drawn from point to point of the edge of the chosen hole is a
// bridge that divides the hole (He 2008, section 4.2). The bridges that the program chose for a long edge are shown and
// changed in the same manner.
class FillHoleTool : public Tool {
 public:
  // Only the destructor may be called after the document has been destroyed. first: the key of the hole that is chosen
  // first.
  FillHoleTool(MeshDocument& document, FillServices services, std::optional<Vertex> first = std::nullopt);

  // Receives the answer to a request; a late answer is not shown.
  void previewReady(std::uint64_t ticket, FillAttempt attempt);

  enum class State {
    Choosing,    // no hole is chosen
    Computing,   // the patch is being computed
    Ready,       // there is a patch
    Impossible,  // there is no patch
    Committing,  // the patch is being added
  };
  State state() const { return m_state; }
  // The chosen hole; null in the state Choosing.
  const BoundaryLoop* loop() const;
  // The result of the request; valid in the states Ready and Impossible.
  const FillAttempt& attempt() const { return m_attempt; }

  static std::span<const ToolKey> keys();
  std::string id() const override { return "fill"; }
  ToolReply pointer(const PointerEvent& event) override;
  ToolReply perform(std::string_view action) override;
  std::vector<ToolAction> actions() const override;
  ToolPreview preview() const override;
  std::vector<Property> settings() const override;
  void setSetting(std::string_view id, const PropertyValue& value) override;
  bool remembersSettings() const override { return false; }  // FillServices::values stores them
  void documentChanged() override;
  std::vector<std::string> needs() const override { return {"picking", "fill preview"}; }

 private:
  void choose(std::optional<Vertex> key);
  void request();
  // Returns the key of the first hole that is not kept open, searched from this index on, forwards or backwards, with
  // wrap-around.
  std::optional<Vertex> holeFrom(std::size_t index, bool forward = true) const;
  std::optional<Vertex> neighbour(bool forward) const;
  std::optional<Vertex> holeAt(const PointerEvent& event) const;
  ToolReply press(const PointerEvent& event);
  // Returns the index of the point of the chosen loop under the pointer.
  std::optional<std::uint32_t> pointAt(const PointerEvent& event) const;
  std::vector<Vec3> line(const HoleBridge& bridge) const;
  ToolReply commit();
  ToolReply keepOpen();

  MeshDocument& m_document;
  FillServices m_services;
  State m_state = State::Choosing;
  std::optional<Vertex> m_key;
  std::optional<Vertex> m_hovered;
  std::size_t m_index = 0;  // index of the chosen loop in the mesh for which it was chosen
  std::uint64_t m_ticket = 0;
  bool m_isCommitWanted = false;  // commits as soon as there is a patch
  FillAttempt m_attempt;
  BridgeEditing m_bridges;
  std::shared_ptr<const TriangleSoup> m_patch;
};

}  // namespace handwheel
