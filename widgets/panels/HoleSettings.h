// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/MethodTable.h"

#include <QFrame>
#include <span>

class QAction;
class QCheckBox;
class QComboBox;
class QLabel;
class QToolButton;

namespace handwheel {

// What the present preview has to say about itself.
struct PreviewState {
  enum class Kind { Off, Working, Ready, Failed };
  Kind kind = Kind::Off;
  std::size_t triangles = 0;                // when ready
  FillMethod method = FillMethod::Fair;     // that made the patch; differs from the chosen one when that gave none
  FillFailure failure = FillFailure::None;  // when failed
};

// The settings for filling the selected hole, with its buttons. They act at once on the preview.
class HoleSettings : public QFrame {
  Q_OBJECT

 public:
  // The actions are those of the menus and keys. others: further ways to close it, shown where they are possible.
  HoleSettings(QAction* fill, QAction* keepOpen, QAction* preview, const QList<QAction*>& others,
               QWidget* parent = nullptr);

  // Those to choose from, in order.
  static std::span<const FillMethod> methods();
  FillMethod method() const;
  void setMethod(FillMethod method);
  void showLoop(const QString& name, const QString& detail);
  void showPreview(const PreviewState& state);
  // The methods side by side are open: somebody wants to see their figures.
  bool isComparing() const;
  void showTrials(const std::vector<MethodTrial>& trials);

 signals:
  void methodChanged(handwheel::FillMethod method);
  void compareWanted();

 private:
  QToolButton* compareButton();

  QLabel* m_name;
  QLabel* m_detail;
  QComboBox* m_method;
  QLabel* m_status;
  MethodTable* m_trials;
};

}  // namespace handwheel
