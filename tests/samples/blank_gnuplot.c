// SPDX-License-Identifier: BSD-3-Clause
// gnuplot for tests that ask nothing of pictures, each of which would take longer than the run that is drawn: an empty picture of the kind that the script
// wants, where berm wants it. gnuplot -d -e "picture = 'FILE'" SCRIPT
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/// A point of white, by zlib.
static const char png[] = "\x89PNG\r\n\x1a\n\0\0\0\15IHDR\0\0\0\1\0\0\0\1\x8\0\0\0\0\x3a\x7e\x9b\x55"
                          "\0\0\0\12IDAT\x78\xda\x63\xf8\xf\0\1\1\1\0\x1c\xb0\x8c\x99\0\0\0\0IEND\xae\x42\x60\x82";
static const char svg[] = "<svg xmlns='http://www.w3.org/2000/svg' width='1' height='1'></svg>\n";

/// Ends the program where that is not there.
static void* need(void* what, const char* name)
{
  if (what != NULL) return what;
  fprintf(stderr, "gnuplot: %s\n", name);
  exit(1);
}

int main(int count, char** words)
{
  char* const begin = count == 5 ? strchr(words[3], '\'') : NULL;
  need(begin, "tests know no such command");
  char* end = begin;  // '' stands for '
  for (const char* from = begin + 1; *from != '\0' && (from[0] != '\'' || from[1] == '\''); ++from) {
    if (*from == '\'') ++from;
    *end++ = *from;
  }
  *end = '\0';
  FILE* const script = need(fopen(words[4], "r"), words[4]);
  char line[4096];
  int is_svg = 0, has_terminal = 0;
  while (fgets(line, sizeof line, script) != NULL)
    if (strncmp(line, "set terminal ", 13) == 0) {
      has_terminal = 1;
      is_svg = strncmp(line + 13, "svg", 3) == 0;
    }
  fclose(script);
  need(has_terminal ? words : NULL, "the script says no terminal");
  FILE* const picture = need(fopen(begin, "wb"), begin);
  if (is_svg)
    fwrite(svg, 1, sizeof svg - 1, picture);
  else
    fwrite(png, 1, sizeof png - 1, picture);
  return fclose(picture) == 0 ? 0 : 1;
}
