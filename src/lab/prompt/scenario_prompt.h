/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Asks which scenario is opened, with a list to choose from. */
#ifndef LAB_PROMPT_SCENARIO_PROMPT_H
#define LAB_PROMPT_SCENARIO_PROMPT_H

typedef struct Laboratory Laboratory;

void scenario_prompt_ask(Laboratory *);

#endif
