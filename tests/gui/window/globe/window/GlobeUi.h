// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Service.h"
#include "globe/document/GlobeDocument.h"
#include "globe/simulation/GlobeForce.h"
#include "window/kinds/KindUi.h"

namespace handwheel {
class PropertyList;
}

namespace handwheel::test {

class PointsLayer;

// The user interface of globes. It has its own layer of points and its own contact force. The poles of the globe
// attract the tip of a haptic device.
class GlobeUi : public KindUi {
 public:
  // sample: a file of this kind.
  GlobeUi(const WindowContext& window, QString sample);
  ~GlobeUi() override;

  std::unique_ptr<DocumentTab> open(std::unique_ptr<Document> document) override;
  void setDocument(DocumentTab* document) override;
  void refreshVisibility() override;
  void showPreview(const ToolPreview& preview) override;
  std::vector<StartAction> startActions() const override;
  QString panelTitle() const override { return QStringLiteral("Shape of the globe"); }
  QString panelIcon() const override { return QStringLiteral("kind-globe"); }
  QWidget* panel() override;
  QString menuTitle() const override { return QStringLiteral("&Globe"); }
  QList<QAction*> menu() override { return {}; }
  QList<QAction*> toolBar() override { return {}; }
  std::vector<ToolDescriptor> tools() override;
  std::vector<Hint> hints() override;
  QString statistics() const override;
  QString openedText(const DocumentTab& opened) const override;

  const PointsLayer& layer() const { return *m_layer; }

 private:
  GlobeDocument& globe() const;
  void show();
  void showBodies(const BodySet& bodies);
  void followTool();
  void feel(bool isEdit);

  WindowContext m_window;
  QString m_sample;
  Service m_dents;
  std::shared_ptr<PointsLayer> m_layer;
  PropertyList* m_panel;
  DocumentTab* m_document = nullptr;
  std::shared_ptr<DentChannel> m_dented;  // channel of the running tool; null: the tool does not dent
  bool m_isPreviewed = false;
};

}  // namespace handwheel::test
