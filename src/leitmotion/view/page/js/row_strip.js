// The strip: postures at their times, chosen by the library, as many as have 78 px each.

const STRIP_APART = 78;

if (!several) (() => {
  const canvas = document.createElement("canvas");
  const element = make("div", "row strip", canvas, { "aria-hidden": "true" });
  seekable(element);
  timeRows.push({
    order: 10,
    element,
    layout(width) {
      const height = element.clientHeight;
      const pen = sized(canvas, timeline.element.clientWidth, height);
      const fits = strips.filter((times) => {
        for (let k = 1; k < times.length; k++) if (across(times[k] - times[k - 1]) < STRIP_APART) return false;
        return times.length > 0;
      });
      const times = fits.reduce((a, b) => (b.length > a.length ? b : a), []);
      element.dataset.times = Array.from(times, (time) => time.toFixed(2)).join(" ");
      for (const time of times) {
        drawSmall(pen, time, { x: timeline.left + across(time), base: height - 4, height: height - 11, width: STRIP_APART - 8, row: true });
      }
    },
  });
})();
