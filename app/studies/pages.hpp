// The parts of the Studies drawer. Each fills the room that it is given and scrolls in itself.
#pragma once

#include "app/studies/desk.hpp"

namespace pf::app {

/// A study of the scene as edited, set up and begun; or one opened.
void draw_set_up_page(AppContext& context, StudyDesk& desk);
/// Asks where to, then writes the study file; `name` proposes the file's.
void ask_save_study(AppContext& context, const std::string& name, std::string text);
/// What is varied: a row for each setting with its values.
void draw_axes(AppContext& context, StudyDesk& desk);
/// The button "Open…" and its list of shipped and earlier ones.
/// `first`: it begins a line; else it stands beside the item before it, where there is room.
void draw_open_menu(AppContext& context, StudyDesk& desk, bool first);

/// The study that is open: how far it is, its charts, what it answers.
void draw_results_page(AppContext& context, StudyDesk& desk);
/// "Cheapest setting for an error below ...", and its answer.
void draw_cheapest(AppContext& context, StudyDesk& desk);
/// The chart that is shown, with the live scene's place in it.
void draw_study_chart(AppContext& context, StudyDesk& desk);

}  // namespace pf::app
