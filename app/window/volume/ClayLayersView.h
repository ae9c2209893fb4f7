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

// The panel of the layers of clay. The topmost layer is first. Layers are renamed and turned on and off in the list;
// the slider sets the strength. The resulting volume is computed on another thread; of the changes made during the
// computation, only the last one is applied. All functions must be called on the window thread.
class ClayLayersView : public QObject {
  Q_OBJECT

 public:
  ClayLayersView(const WindowContext& parts, QObject* parent);

  QAction* action() { return &m_toggle; }  // shows and hides the panel
  // Sets the current document. null: no volume is current, or it must not be changed. reason: the translated reason why
  // the volume must not be changed. The panel is shown for a volume with layers.
  void setDocument(DocumentTab* document, const QString& reason);
  // Tells the user why the topmost layer accepts no strokes.
  void refuse();

 signals:
  void message(const handwheel::Message& message);

 private:
  // A requested change of a layer's strength or state that is not yet applied to the volume.
  struct Wanted {
    int layer;
    const char* what;  // the changed property: "strength" or "on"
    double strength;
    bool isOn;
    DragPhase phase;
    quint64 number;  // sequence number of the request
  };

  using StepOf = LayerStep (*)(const VolumeSnapshot&, std::size_t layer);
  // The removal or merging of a layer.
  struct Step {
    QString text;  // text of the undo step
    StepOf of;
    std::size_t layer;
    std::size_t count;  // number of layers at the start; if it is unchanged, the index still refers to the same layer
    quint64 number;     // sequence number of the step

    bool isPossible(const VolumeSnapshot& volume) const {
      return volume.layers && volume.layers->all().size() == count && layer < count;
    }
  };

  VolumeDocument& volume() const;
  const std::vector<ClayLayer>& layers() const;
  int chosen() const;  // index of the selected layer, 0 for the lowest; -1: none
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
  // isLate: true if the result had to wait for the end of a stroke.
  void take(const std::shared_ptr<const PreparedShare>& share, const Wanted& wanted, bool isLate = false);
  void applyWanted();  // applies the request and the step immediately, on this thread
  void apply(const Wanted& wanted);
  void set(int layer, const char* what, const PropertyValue& value, DragPhase phase);
  void warn(const Error& error);
  double strengthOf(int layer) const;  // requested strength
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
