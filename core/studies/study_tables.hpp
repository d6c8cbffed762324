// The tables of the study file. Not for use outside core/studies.
#pragma once

#include "core/params/json_reader.hpp"
#include "core/scene/keys.hpp"
#include "core/studies/study.hpp"

namespace pf {

/// What the file says, before the scene is found and the runs are made of it.
struct StudyDocument {
  Study study;
  Json scene, vary, reference;  ///< as they stand; null where absent
};

const Table& study_table();

}  // namespace pf
