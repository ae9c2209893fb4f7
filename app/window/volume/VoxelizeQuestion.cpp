// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/volume/VoxelizeQuestion.h"

#include "controls/property/PropertyDialog.h"
#include "document/Document.h"
#include "document/volume/VolumeKind.h"
#include "document/volume/VolumeMaking.h"
#include "panels/MessageBar.h"
#include "text/ErrorText.h"
#include "volume/repair/TriangleWalls.h"
#include "window/JobRunner.h"
#include "window/MemoryQuestion.h"

#include <QLocale>

namespace handwheel {
namespace {

Property said(const char* id, const char* label, const QString& text) {
  Property property{.id = id, .group = {}, .label = label, .value = text.toStdString()};
  property.editable = false;
  return property;
}

}  // namespace

VoxelizeQuestion::VoxelizeQuestion(QWidget* window, JobRunner& jobs, const VolumeKind& kind, QObject* parent)
    : QObject(parent), m_window(window), m_jobs(jobs), m_kind(kind) {}

void VoxelizeQuestion::ask(const Document& from, VoxelizeSettings::Purpose purpose,
                           std::function<void(MakeOfSurface)> start) {
  if (m_dialog) return m_dialog->raise();
  Job job;
  job.name = tr("Measuring %1").arg(from.name());
  job.document = &from;
  job.lane = Job::Lane::Looking;
  job.failed = [this, name = from.name()](const Error& error) {
    if (error.code == ErrorCode::Cancelled) return;
    emit message({Message::Weight::Error, tr("%1 was not copied").arg(name), errorSentence(error), errorAdvice(error)});
  };
  job.work = [this, &kind = from.kind(), content = from.snapshot(), unit = from.displayUnit(), purpose,
              start = std::move(start)](const Progress&) -> Job::Finish {
    return [this, settings = VoxelizeSettings(placedSoup(kind.display(*content)), purpose), unit, start] {
      if (m_dialog) return;
      m_settings = settings;
      open(unit, start);
    };
  };
  m_jobs.start(std::move(job));
}

void VoxelizeQuestion::open(LengthUnit unit, std::function<void(MakeOfSurface)> start) {
  m_dialog = new PropertyDialog(
      {tr("Make a volume"), tr("The volume becomes a document of its own. Whatever is smaller than a voxel is lost."),
       tr("&Make volume")},
      [this] { return shown(); },
      [this](const std::string& id, const PropertyValue& value) -> Status {
        m_settings->change(id, value);
        return Done{};
      },
      m_window);
  m_dialog->setObjectName(QStringLiteral("voxelizeDialog"));
  m_dialog->setModal(true);
  m_dialog->setLengthUnit(unit);
  m_dialog->followTyping();
  connect(m_dialog, &QDialog::finished, this, [this, start = std::move(start)](int result) {
    if (result == QDialog::Accepted)
      askForMemory(m_window, m_settings->bytes(), [start, make = wanted()] { start(make); });
  });
  m_dialog->open();
}

std::vector<Property> VoxelizeQuestion::shown() const {
  std::vector<Property> all = m_settings->properties();
  const QString across = tr("%1 voxels along the largest extent: %2")
                             .arg(QLocale().toString(std::round(m_settings->across()), 'f', 0), reasonText());
  all.insert(all.begin() + 1, said("reason", QT_TRANSLATE_NOOP("Property", "Size of the voxels"), across));
  all.push_back(said("memory", QT_TRANSLATE_NOOP("Property", "Memory"), memoryText(m_settings->bytes())));
  all.push_back(said("seconds", QT_TRANSLATE_NOOP("Property", "Time"),
                     tr("about %1 s").arg(QLocale().toString(m_settings->seconds(), 'g', 1))));
  return all;
}

QString VoxelizeQuestion::reasonText() const {
  switch (m_settings->reason()) {
    case VoxelizeSettings::Reason::Drilling:
      return tr("by the resolution rule of drilling, at 1 mm/s and 1 kHz");
    case VoxelizeSettings::Reason::Extent:
      return tr("256 to the largest extent");
    case VoxelizeSettings::Reason::Wall:
      return tr("four to the thickness of a wall");
    case VoxelizeSettings::Reason::Chosen:
      break;
  }
  return tr("as chosen");
}

MakeOfSurface VoxelizeQuestion::wanted() const {
  return
      [settings = *m_settings, &kind = m_kind](const TriangleSoup& surface, const std::string& source,
                                               std::vector<Note>& notes, Progress progress) -> Result<SnapshotPointer> {
        const Result<MadeVolume> made =
            makeVolume(settings.wall() ? wallsOf(surface, *settings.wall()) : surface, settings.voxel(), source,
                       progress, settings.method(), kind.pieceCells());
        if (!made) return made.error();
        notes = notesOn(made->surface);
        return SnapshotPointer(made->volume);
      };
}

}  // namespace handwheel
