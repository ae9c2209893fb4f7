// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/volume/RemeshAction.h"

#include "controls/property/PropertyDialog.h"
#include "document/volume/VolumeDocument.h"
#include "panels/LogModel.h"
#include "panels/MessageBar.h"
#include "text/ErrorText.h"
#include "tools/OperationSettings.h"
#include "tools/ToolProperty.h"
#include "window/ActionToolTip.h"
#include "window/documents/DocumentTab.h"

#include <QFileInfo>
#include <QLocale>
#include <QPointer>
#include <cmath>

namespace handwheel {

RemeshAction::RemeshAction(const WindowContext& parts, QObject* parent)
    : QObject(parent),
      m_parts(parts),
      m_action(tr("Make &mesh…"), this),
      m_values(remeshOperation()),
      m_predicting(JobRunner::Policy::Latest, parts.pool) {
  prepare(m_action, "volumeRemesh", "kind-mesh",
          tr("Open the surface as a mesh, with as many triangles as are wanted"));
  m_action.setEnabled(false);
  connect(&m_action, &QAction::triggered, this, &RemeshAction::ask);
}

void RemeshAction::setDocument(DocumentTab* document) {
  if (document != m_document && m_dialog) m_dialog->reject();
  m_document = document;
  m_action.setEnabled(document != nullptr);
}

void RemeshAction::ask() {
  if (m_dialog) return m_dialog->raise();
  Document& document = m_document->document;
  document.settle();
  m_volume = static_cast<VolumeDocument&>(document).volume();
  m_values = OperationValues(remeshOperation());
  constexpr double kShare = 0.25;  // share of a voxel, less than the error of sampling at edges
  m_values.setValid("error", kShare * m_volume->volume.voxel());
  m_values.setValid("faces", std::max(4.0, std::round(0.5 * static_cast<double>(m_volume->surface.triangleCount()))));
  m_dialog = new PropertyDialog(
      {tr("Make a mesh"),
       tr("The mesh becomes a document of its own. It is closed and manifold, and meets "
          "itself nowhere."),
       tr("&Make mesh")},
      [this] { return shown(); },
      [this](const std::string& id, const PropertyValue& value) { return change(id, value); }, m_parts.window);
  m_dialog->setObjectName(QStringLiteral("remeshDialog"));
  m_dialog->setModal(true);
  m_dialog->setLengthUnit(document.displayUnit());
  // The name of the volume, without its extension.
  const std::string title = document.path().isEmpty() || !document.file().title.empty()
                                ? document.file().title
                                : QFileInfo(document.path()).completeBaseName().toStdString();
  connect(m_dialog, &QDialog::finished, this,
          [this, title, isPrivate = document.file().hasPrivateName, unit = document.displayUnit(),
           owner = QPointer<const Document>(&document)](int result) {
            m_predicting.cancelAll();
            if (result == QDialog::Accepted) make(title, isPrivate, unit, owner);
            m_volume.reset();
          });
  predict();
  m_dialog->open();
}

std::vector<Property> RemeshAction::shown() const {
  std::vector<Property> all = {
      choiceSetting("goal", QT_TRANSLATE_NOOP("Property", "Triangles"), static_cast<int>(m_goal),
                    {QT_TRANSLATE_NOOP("Property", "All of the surface"),
                     QT_TRANSLATE_NOOP("Property", "Within a distance"), QT_TRANSLATE_NOOP("Property", "So many")}),
      settingOf(m_values, "method")};
  if (m_goal == Goal::Distance) all.push_back(settingOf(m_values, "error"));
  if (m_goal == Goal::Count) {
    all.push_back(settingOf(m_values, "faces"));
    all.back().least = 4.0;
  }
  // The other method makes more triangles along sharp edges.
  const bool isExact = m_goal == Goal::All && m_values.whole("method") == 0;
  const auto say = [&](const char* id, const char* label, const QString& text) {
    Property said{.id = id, .group = {}, .label = label, .value = text.toStdString()};
    said.editable = false;
    all.push_back(std::move(said));
  };
  const QLocale locale;
  say("predicted", QT_TRANSLATE_NOOP("Property", "Triangles of the mesh"),
      m_predicted
          ? (isExact ? tr("%1") : tr("about %1")).arg(locale.toString(std::round(m_predicted->triangles), 'f', 0))
          : tr("being counted…"));
  say("seconds", QT_TRANSLATE_NOOP("Property", "Time"),
      m_predicted ? tr("about %1 s").arg(locale.toString(m_predicted->seconds, 'g', 1)) : tr("being counted…"));
  return all;
}

Status RemeshAction::change(const std::string& id, const PropertyValue& value) {
  if (id == "goal")
    assignChoice(m_goal, value, 3);
  else
    takeSetting(m_values, id, value);
  predict();
  return Done{};
}

OperationValues RemeshAction::wanted() const {
  OperationValues values = m_values;
  if (m_goal != Goal::Distance) values.reset("error");
  if (m_goal != Goal::Count) values.reset("faces");
  return values;
}

// The prediction reduces sample pieces of the surface, which takes a moment.
void RemeshAction::predict() {
  m_predicted.reset();
  Job job;
  job.name = tr("Counting triangles");
  job.work = [this, values = wanted(), volume = m_volume](Progress progress) -> Job::Finish {
    const RemeshPrediction predicted = predictRemesh(volume->surface, values, progress);
    if (progress.cancelled()) return {};
    return [this, predicted] {
      m_predicted = predicted;
      if (m_dialog) m_dialog->refresh();
    };
  };
  m_predicting.start(std::move(job));
}

void RemeshAction::make(const std::string& title, bool isPrivate, LengthUnit unit, const Document* owner) {
  Job job;
  job.name = tr("Making the mesh");
  job.document = owner;
  job.lane = Job::Lane::Looking;
  job.outlivesDocument = true;
  const auto failed = [this](const Error& error) {
    if (error.code == ErrorCode::Cancelled) return;
    emit message({Message::Weight::Error, tr("The mesh was not made"), errorSentence(error), errorAdvice(error)});
  };
  job.work = [this, failed, title, isPrivate, unit, values = wanted(), volume = m_volume,
              kind = m_parts.kinds.withId("mesh")](Progress progress) -> Job::Finish {
    const Result<Remeshed> made = remesh(volume->volume, values, progress.part(0.0, 0.8));
    if (!made) return [failed, error = made.error()] { failed(error); };
    const Result<SnapshotPointer> content =
        kind->ofSurface(made->mesh.compact().soup, volume->source, progress.part(0.8, 1.0));
    if (!content) return [failed, error = content.error()] { failed(error); };
    OpenedFile opened{kind, {}, *content};
    opened.file.id = newDocumentId();
    opened.file.title = title;
    opened.file.hasPrivateName = isPrivate;
    opened.file.displayUnit = unit;
    const QString said = tr("Mesh made of %1 triangle(s): %2 of them left")
                             .arg(QLocale().toString(static_cast<qulonglong>(made->before)),
                                  QLocale().toString(static_cast<qulonglong>(made->mesh.liveFaceCount())));
    return [this, said, opened]() mutable {
      // The mesh has no file, so the user is asked to save it before it is closed.
      m_parts.openDocument(std::move(opened))->document.markRecovered({});
      m_parts.log.add(said);
    };
  };
  job.failed = failed;
  m_parts.jobs.start(std::move(job));
}

}  // namespace handwheel
