// Studies: one being set up, or the one that is open.
#include "app/panels/panels.hpp"
#include "app/studies/pages.hpp"

namespace pf::app {

void draw_studies_panel(AppContext& context) {
  StudyDesk& desk = studies_of(context);
  desk.follow(context);
  const bool nothing_open = !desk.results && !desk.status.active() && desk.status.stage != StudyStage::failed;
  if (desk.page == StudyDesk::Page::set_up || nothing_open)
    draw_set_up_page(context, desk);
  else
    draw_results_page(context, desk);
}

}  // namespace pf::app
