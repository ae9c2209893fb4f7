// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "nurbs/StepWriter.h"

#include "nurbs/step/StepLibrary.h"

#include <dlfcn.h>
#include <filesystem>

namespace handwheel {

namespace {

constexpr const char* kLibrary = "libhw_step.so";  // core/nurbs/CMakeLists.txt makes it

Error notLoaded() {
  const char* const reason = ::dlerror();
  return {ErrorCode::LibraryFailed, {"Open CASCADE", reason ? reason : ""}, {}, {}};
}

// Open CASCADE has a third of all symbols that the program would look up at each start, and only STEP needs it. The
// library that links it lies beside this one; the whole path is used, because sanitizers remove our search path from
// dlopen().
Result<const StepFunctions*> loadedStepFunctions() {
  Dl_info ours{};
  if (::dladdr(reinterpret_cast<const void*>(&loadedStepFunctions), &ours) == 0 || !ours.dli_fname) return notLoaded();
  const std::filesystem::path file = std::filesystem::path(ours.dli_fname).parent_path() / kLibrary;
  void* const library = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);  // stays until the program ends
  if (!library) return notLoaded();
  void* const found = ::dlsym(library, "handwheelStepFunctions");
  if (!found) return notLoaded();
  return reinterpret_cast<decltype(&handwheelStepFunctions)>(found)();
}

const Result<const StepFunctions*>& stepFunctions() {
  static const Result<const StepFunctions*> functions = loadedStepFunctions();
  return functions;
}

}  // namespace

Result<std::string> writeStep(const ProfileCurve& profile, Progress progress) {
  const Result<const StepFunctions*>& functions = stepFunctions();
  return functions ? (*functions)->write(profile, progress) : functions.error();
}

Result<StepFileReport> inspectStep(std::string_view bytes, Progress progress) {
  const Result<const StepFunctions*>& functions = stepFunctions();
  return functions ? (*functions)->inspect(bytes, progress) : functions.error();
}

}  // namespace handwheel
