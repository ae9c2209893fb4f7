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

// Request to propose a patch for a hole.
struct FillRequest {
  std::uint64_t ticket = 0;  // returned with the answer
  BoundaryLoop loop;
  std::vector<HoleBridge> bridges = {};  // as in FillOptions
};

// Services for FillHoleTool, provided by the owner of the document's jobs. All of them are called on the window thread.
struct FillServices {
  // How holes are filled: shared with the owner, so that a choice holds for the next hole and the next start.
  std::shared_ptr<OperationValues> values = std::make_shared<OperationValues>(fillOperation());
  std::function<std::shared_ptr<const FaceHierarchy>()> faces;  // "picking", as in MeshServices
  // "fill preview": proposes a patch, and answers by previewReady(), now or later. A request replaces the previous one.
  std::function<void(const FillRequest&)> request;
  // Puts a proposed patch into the document as one step, now or later. False where something else is under way.
  std::function<bool(const BoundaryLoop&, const FillAttempt&)> commit;
  // Whether the patch is to be seen before it is put in.
  std::function<bool()> showsPatch = [] { return true; };
};

// Tool that fills holes one by one, with a preview of the patch. Choose a hole, see the patch, accept it or not, go on
// to the next. A line drawn from point to point of the chosen hole's edge is a bridge that divides the hole there (He
// 2008, section 4.2); those that the program chose for a long edge are shown and changed in the same way.
class FillHoleTool : public Tool {
 public:
  // The document must outlive all calls but the destructor's. first: the key of the hole to begin with.
  FillHoleTool(MeshDocument& document, FillServices services, std::optional<Vertex> first = std::nullopt);

  // The answer to a request; one that came too late is not shown.
  void previewReady(std::uint64_t ticket, FillAttempt attempt);

  enum class State {
    Choosing,    // no hole is chosen
    Computing,   // the patch is on its way
    Ready,       // there is a patch
    Impossible,  // there is none
    Committing,  // it is being put in
  };
  State state() const { return m_state; }
  // The chosen hole; null in the state Choosing.
  const BoundaryLoop* loop() const;
  // In the states Ready and Impossible.
  const FillAttempt& attempt() const { return m_attempt; }

  static std::span<const ToolKey> keys();
  std::string id() const override { return "fill"; }
  ToolReply pointer(const PointerEvent& event) override;
  ToolReply perform(std::string_view action) override;
  std::vector<ToolAction> actions() const override;
  ToolPreview preview() const override;
  std::vector<Property> settings() const override;
  void setSetting(std::string_view id, const PropertyValue& value) override;
  bool remembersSettings() const override { return false; }  // FillServices::values does
  void documentChanged() override;
  std::vector<std::string> needs() const override { return {"picking", "fill preview"}; }

 private:
  void choose(std::optional<Vertex> key);
  void request();
  // The key of the first hole that is not kept open, looked for from this index on (or back), around the end.
  std::optional<Vertex> holeFrom(std::size_t index, bool forward = true) const;
  std::optional<Vertex> neighbour(bool forward) const;
  std::optional<Vertex> holeAt(const PointerEvent& event) const;
  ToolReply press(const PointerEvent& event);
  // The point of the chosen loop that is pointed at, as its number.
  std::optional<std::uint32_t> pointAt(const PointerEvent& event) const;
  std::vector<Vec3> line(const HoleBridge& bridge) const;
  ToolReply commit();
  ToolReply keepOpen();

  MeshDocument& m_document;
  FillServices m_services;
  State m_state = State::Choosing;
  std::optional<Vertex> m_key;
  std::optional<Vertex> m_hovered;
  std::size_t m_index = 0;  // of the chosen loop, in the mesh for which it was chosen
  std::uint64_t m_ticket = 0;
  bool m_isCommitWanted = false;  // as soon as there is a patch
  FillAttempt m_attempt;
  BridgeEditing m_bridges;
  std::shared_ptr<const TriangleSoup> m_patch;
};

}  // namespace handwheel
