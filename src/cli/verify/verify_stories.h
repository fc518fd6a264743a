/* Runs that take long and are told of in two figures: made by the first that asks, kept in the Verify. */
#ifndef CLI_VERIFY_STORIES_H
#define CLI_VERIFY_STORIES_H

#include "cli/verify/verify_sheet.h"

void moving_story_free(struct MovingStory *story); /* NULL is allowed */
void crack_story_free(struct CrackStory *story);

#endif
