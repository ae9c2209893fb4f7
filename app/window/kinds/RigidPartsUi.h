// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "viewport/ViewportTypes.h"
#include "window/kinds/KindUi.h"

#include <QPointer>

namespace handwheel {

class PartsLayer;
class PropertyList;
class RigidPartsHaptics;

// Base class for documents shown as rigid parts and edited through properties. Robot cells and workpieces use it.
class RigidPartsUi : public KindUi {
  Q_OBJECT

 public:
  // groups: the groups of properties in the panel of the kind. firstView: the view of a document that was never viewed.
  RigidPartsUi(const WindowContext& parts, std::vector<std::string> groups,
               StandardView firstView = StandardView::Isometric);
  ~RigidPartsUi() override;

  std::unique_ptr<DocumentTab> open(std::unique_ptr<Document> document) override;
  void setDocument(DocumentTab* document) override;
  void refreshVisibility() override;
  void showPreview(const ToolPreview& preview) override;
  QWidget* panel() override;
  QList<QAction*> menu() override { return {}; }
  QList<QAction*> toolBar() override { return {}; }
  std::vector<Hint> hints() override;
  bool isSettled() const override;

 protected:
  DocumentTab* document() const { return m_document; }
  const WindowContext& parts() const { return m_parts; }
  ToolDescriptor measureParts() const;
  // Sets if the haptic device feels the surfaces of the displayed parts. Must be false while a tool applies its own
  // forces.
  void setFelt(bool isFelt);
  // Returns the properties in the panel of the kind. By default these are the properties of its groups.
  virtual std::vector<Property> panelProperties(const Document& document) const;
  // Returns the groups in the panel of the kind that can be folded, with true for those that are unfolded at first. By
  // default there are none.
  virtual std::map<std::string, bool> foldingGroups(const Document& document) const {
    (void)document;
    return {};
  }
  // Returns true if the document shows work in a lathe, whose axis is level in all standard views.
  virtual bool isOfLathe() const { return m_firstView == StandardView::Lathe; }
  // Handles an edit in the panel of the kind that does not belong to the document. Returns false if it belongs to the
  // document.
  virtual bool takeEdit(const std::string& id, const PropertyValue& value, bool stillDragging) {
    (void)id, (void)value, (void)stillDragging;
    return false;
  }
  // Returns the display model of the document. By default it is that of DocumentKind::display().
  virtual DisplayModel displayed(const Document& document) const;
  void show();  // Updates the display; must be called after the model has changed
  // Shows other parts instead of those of the document, unless a tool shows parts of its own; null: those of the
  // document.
  void showInstead(const std::shared_ptr<const DisplayModel>& model);
  // Shows other parts, such as those of a replay, instead of all others; null: none.
  void showPast(const std::shared_ptr<const DisplayModel>& model);
  PartsLayer& layer() { return *m_layer; }
  void refreshPanel();
  std::vector<QAction*> panelActions() const;  // Actions of suggestion(); empty unless the panel is hidden

 private:
  void showParts();
  void feelParts();

  WindowContext m_parts;
  std::vector<std::string> m_groups;
  StandardView m_firstView;
  std::shared_ptr<PartsLayer> m_layer;
  RigidPartsHaptics* m_haptics;
  bool m_isFelt = true;
  std::shared_ptr<const DisplayModel> m_model;     // Model of the document; null: none
  std::shared_ptr<const DisplayModel> m_replaced;  // Model of the tool; null: none
  std::shared_ptr<const DisplayModel> m_instead;   // Model of showInstead()
  std::shared_ptr<const DisplayModel> m_past;      // Model of showPast()
  QPointer<PropertyList> m_panel;
  DocumentTab* m_document = nullptr;
};

}  // namespace handwheel
