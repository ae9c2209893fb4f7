// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "window/JobRunner.h"
#include "window/kinds/KindUi.h"
#include "window/volume/segmentation/SegmentationPanel.h"

#include <QAction>
#include <QPointer>
#include <functional>
#include <vector>

class QDockWidget;

namespace handwheel {

class SlicesPanel;
class VolumeDocument;

// The segmentation of a scan in the window: the docks “Segmentation” and “Slices”. They are shown while a document with
// a scan is current, unless the user has closed them. Every change of the segment is an edit of the document. All
// functions must be called on the window thread.
class Segmentation : public QObject {
  Q_OBJECT

 public:
  Segmentation(const WindowContext& parts, QObject* parent);

  QAction* action() { return &m_toggle; }
  void setDocument(DocumentTab* document);
  // Removes all references to a document. Must be called before the document is destroyed.
  void forget(DocumentTab* document);
  bool isSettled() const { return m_counting.isIdle() && !m_pause.isActive(); }

 signals:
  void message(const handwheel::Message& message);

 private:
  // The result of a job on a segment: the new segment or an error.
  struct Changed {
    std::optional<Segment> segment;
    QString problem = {};
  };
  using Change = std::function<Changed(const Scan&, const Segment&, const SegmentParts&, Progress)>;

  VolumeDocument& volume() const;
  // Returns true if the segment was changed after the surface was made.
  bool isOlder() const;
  bool isOpen() const { return m_document && m_toggle.isChecked(); }
  void makeDocks();
  void connectSlices();
  void show();
  void refresh();
  void count();
  void commit(Segment segment, const QString& text);
  void setRange(const ValueRange& range, bool stillDragging);
  void begin(int through, const Vec3& index, bool opposite);
  void paint(const Vec3& index);
  void endStroke();
  void dropStroke();
  void commitWaiting();
  // Commits immediately, or after the end of the stroke that is being painted on this document.
  void afterStroke(const Document& document, std::function<void()> commit);
  void setBrush();
  void setGreys(const GreyWindow& greys);
  // Runs a change as a job, and repeats the job if the segment was changed during it.
  void change(const QString& name, const QString& text, const Change& how);
  void startChange(VolumeDocument* document, const QString& name, const QString& text, const Change& how);
  void keepFirst(int parts);
  void grow(const Vec3& index);
  void askForSurface();
  void makeSurface();
  void fail(const Document& document, const QString& what, const QString& why);

  // An unfinished stroke of the brush.
  struct Stroke {
    Segment segment;
    std::optional<int> plane;
    double radius;
    bool isErasing;
    Vec3 last;
  };

  // The result of a job that finished during a stroke.
  struct Waiting {
    const Document* document;
    std::function<void()> commit;
  };

  WindowContext m_parts;
  QAction m_toggle;
  QPointer<QDockWidget> m_panelDock, m_slicesDock;
  QPointer<SegmentationPanel> m_panel;
  QPointer<SlicesPanel> m_slices;
  DocumentTab* m_document = nullptr;  // null: the current document has no scan
  Segment m_shown;
  std::optional<Stroke> m_stroke;
  std::vector<Waiting> m_waiting;
  SegmentStatistics m_figures;  // statistics of m_counted
  Segment m_counted;
  QTimer m_pause;  // delay after the last change of the segment, before it is counted
  JobRunner m_counting;
};

}  // namespace handwheel
