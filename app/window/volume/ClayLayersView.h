// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Document.h"
#include "document/volume/LayerSteps.h"
#include "window/JobRunner.h"
#include "window/kinds/KindUi.h"

#include <QAction>
#include <QPointer>
#include <optional>

class QDockWidget;
class QLabel;
class QListWidget;
class QListWidgetItem;
class QPushButton;
class QSlider;

namespace handwheel {

class VolumeDocument;

// The panel of the layers of clay. The topmost layer is first: it is renamed, turned off and on in the list, the slider
// is its strength. What becomes of the volume then, or without a layer, is computed on another thread; of what comes in
// meanwhile the last counts. Window thread.
class ClayLayersView : public QObject {
  Q_OBJECT

 public:
  ClayLayersView(const WindowContext& parts, QObject* parent);

  QAction* action() { return &m_toggle; }  // shows and hides the panel
  // null: no volume is current, or none that is to be changed, for this reason (translated). A volume with layers shows
  // the panel.
  void setDocument(DocumentTab* document, const QString& reason);
  // Says why the topmost layer takes no strokes.
  void refuse();

 signals:
  void message(const handwheel::Message& message);

 private:
  // A share of a layer that is not in the volume yet.
  struct Wanted {
    int layer;
    const char* what;  // its property that is another one: "strength" or "on"
    double strength;
    bool isOn;
    DragPhase phase;
    quint64 number;  // of all that were wanted
  };

  using StepOf = LayerStep (*)(const VolumeSnapshot&, std::size_t layer);
  // A layer that is being taken away or merged.
  struct Step {
    QString text;  // of the undo step
    StepOf of;
    std::size_t layer;
    std::size_t count;  // of layers then: with as many, the layer is still the one that was meant
    quint64 number;     // of all that were started

    bool isPossible(const VolumeSnapshot& volume) const {
      return volume.layers && volume.layers->all().size() == count && layer < count;
    }
  };

  VolumeDocument& volume() const;
  const std::vector<ClayLayer>& layers() const;
  int chosen() const;  // number of a layer, the lowest being 0; -1: none
  void makeDock();
  void show();
  void refresh();
  void refreshChosen();
  void add();
  void commit(const QString& text, const LayerStep& step);
  void start(const QString& text, StepOf of);
  void computeStep();
  void finish(quint64 number, const std::shared_ptr<const VolumeSnapshot>& before,
              const std::shared_ptr<const LayerStep>& made);
  void take(const QListWidgetItem& item);
  void setStrength(DragPhase phase);
  void want(Wanted wanted);
  void compute();
  bool isStrokeLive() const;
  // isLate: a stroke was waited for.
  void take(const std::shared_ptr<const PreparedShare>& share, const Wanted& wanted, bool isLate = false);
  void applyWanted();  // and a step, at once, on this thread
  void apply(const Wanted& wanted);
  void set(int layer, const char* what, const PropertyValue& value, DragPhase phase);
  void warn(const Error& error);
  double strengthOf(int layer) const;  // as it is wanted
  bool isOn(int layer) const;

  WindowContext m_parts;
  QAction m_toggle;
  DocumentTab* m_document = nullptr;
  std::shared_ptr<const ClayLayers> m_shown;
  std::optional<Wanted> m_wanted;
  quint64 m_wantedCount = 0;
  bool m_isComputing = false;
  std::optional<Step> m_step;
  quint64 m_stepCount = 0;
  QPointer<QDockWidget> m_dock;
  QListWidget* m_list = nullptr;
  QSlider* m_strength = nullptr;
  QLabel* m_strengthText = nullptr;
  QLabel* m_hint = nullptr;
  QPushButton* m_add = nullptr;
  QPushButton* m_remove = nullptr;
  QPushButton* m_merge = nullptr;
  JobRunner m_computing;
};

}  // namespace handwheel
