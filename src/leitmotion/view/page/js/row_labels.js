// What someone wrote about the recording: one thin lane of words, never in pattern colours.

(() => {
  const given = payload.labels;
  if (!given) return;
  const track = make("div", "track");
  const element = make("div", "row labels", [make("p", "row-head", given.title, { title: given.title }), track], { role: "group", "aria-label": given.title });
  timeRows.push({
    order: 40,
    element,
    layout() {
      track.replaceChildren();
      given.items.forEach(([start, stop, label], k) => {
        const word = label.replaceAll("_", " ");
        const next = k + 1 < given.items.length ? given.items[k + 1][0] : Math.max(stop, clip.seconds);
        const room = across(next - start);
        const item = make("span", "given", room > 9 + word.length * 6.2 ? make("span", "", word) : "", { title: `${word}, ${clockWord(start)} to ${clockWord(stop)}` });
        item.style.left = across(start) + "px";
        item.style.width = Math.max(room, 6) + "px";
        track.append(item);
      });
    },
  });
})();
