<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="uk">
<context>
    <name>App::Property</name>
    <message>
        <source>Base</source>
        <translation>Основа</translation>
    </message>
    <message>
        <source>Measurement</source>
        <translation>Вимірювання</translation>
    </message>
    <message>
        <source>Further parts</source>
        <translation>Інші деталі</translation>
    </message>
    <message>
        <source>Earlier parts</source>
        <translation>Попередні деталі</translation>
    </message>
    <message>
        <source>Switched off</source>
        <translation>Вимкнено</translation>
    </message>
    <message>
        <source>Earlier rounds</source>
        <translation>Попередні цикли</translation>
    </message>
    <message>
        <source>Nominal</source>
        <translation>Номінал</translation>
    </message>
    <message>
        <source>Tool diameter</source>
        <translation>Діаметр інструмента</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Сторона</translation>
    </message>
    <message>
        <source>Align</source>
        <translation>Вирівнювання</translation>
    </message>
    <message>
        <source>Accept</source>
        <translation>Прийняти</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Фільтр</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Метод</translation>
    </message>
    <message>
        <source>Setup</source>
        <translation>Налагодження</translation>
    </message>
    <message>
        <source>Iterate</source>
        <translation>Повторювати</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Глибина</translation>
    </message>
    <message>
        <source>Next depth</source>
        <translation>Наступна глибина</translation>
    </message>
    <message>
        <source>Depth along</source>
        <translation>Глибина вздовж</translation>
    </message>
    <message>
        <source>Transfer function</source>
        <translation>Передавальна функція</translation>
    </message>
    <message>
        <source>Allowance</source>
        <translation>Припуск</translation>
    </message>
    <message>
        <source>Leave stock</source>
        <translation>Залишити припуск</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Коефіцієнт</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Межа</translation>
    </message>
    <message>
        <source>Dead band</source>
        <translation>Зона нечутливості</translation>
    </message>
    <message>
        <source>Unmeasured share</source>
        <translation>Частка без точок</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Інструменти</translation>
    </message>
    <message>
        <source>Keep allowance</source>
        <translation>Зберігати припуск</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Допуск</translation>
    </message>
    <message>
        <source>Output moves</source>
        <translation>Вихідні рухи</translation>
    </message>
    <message>
        <source>Cutter compensation</source>
        <translation>Корекція на радіус</translation>
    </message>
    <message>
        <source>Deviation mean</source>
        <translation>Відхилення середнє</translation>
    </message>
    <message>
        <source>Deviation min</source>
        <translation>Відхилення найменше</translation>
    </message>
    <message>
        <source>Deviation max</source>
        <translation>Відхилення найбільше</translation>
    </message>
    <message>
        <source>Deviation height</source>
        <translation>Відхилення розмах</translation>
    </message>
    <message>
        <source>Deviation std</source>
        <translation>Відхилення станд.</translation>
    </message>
    <message>
        <source>Random std</source>
        <translation>Випадкове станд.</translation>
    </message>
    <message>
        <source>Largest correction</source>
        <translation>Найбільша корекція</translation>
    </message>
    <message>
        <source>Path error</source>
        <translation>Похибка траєкторії</translation>
    </message>
    <message>
        <source>Points used</source>
        <translation>Використані точки</translation>
    </message>
    <message>
        <source>Points rejected</source>
        <translation>Відкинуті точки</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>Попередження</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Джерело</translation>
    </message>
    <message>
        <source>Digest</source>
        <translation>Контрольна сума</translation>
    </message>
    <message>
        <source>Corrected</source>
        <translation>Скориговано</translation>
    </message>
    <message>
        <source>Smoothed</source>
        <translation>Згладжене</translation>
    </message>
    <message>
        <source>Noted</source>
        <translation>Взято до відома</translation>
    </message>
    <message>
        <source>Cut path</source>
        <translation>Фрезерована траєкторія</translation>
    </message>
    <message>
        <source>The operation whose path is corrected</source>
        <translation>Операція, траєкторія якої коригується</translation>
    </message>
    <message>
        <source>The measured part; without one the path is made exact and nothing is corrected</source>
        <translation>Виміряна деталь; без неї траєкторія стає точною, але нічого не коригується</translation>
    </message>
    <message>
        <source>Measurements of further parts cut with the same path; deviations are averaged</source>
        <translation>Вимірювання інших деталей з тією самою траєкторією; відхилення усереднюються</translation>
    </message>
    <message>
        <source>Parts measured in earlier rounds, oldest first; the later ones were cut with their path</source>
        <translation>Деталі, виміряні в попередніх циклах, від найстарішої; пізніші фрезеровано за їхньою траєкторією</translation>
    </message>
    <message>
        <source>Measured parts that count for nothing</source>
        <translation>Виміряні деталі, що не враховуються</translation>
    </message>
    <message>
        <source>Number of parts and settings of each earlier round</source>
        <translation>Кількість деталей і параметри кожного попереднього циклу</translation>
    </message>
    <message>
        <source>Nominal profile; without one the operation's own geometry, or else its path</source>
        <translation>Номінальний контур; без нього геометрія операції, інакше її траєкторія</translation>
    </message>
    <message>
        <source>Diameter of the tool; 0 takes it from the tool controller</source>
        <translation>Діаметр інструмента; 0 бере його з контролера інструмента</translation>
    </message>
    <message>
        <source>Side of the contour on which the tool runs, along its direction</source>
        <translation>Сторона контуру, з якої йде інструмент за його напрямом</translation>
    </message>
    <message>
        <source>Best fit of the measured points before comparing: none, shift, rigid, or some of x, y, turn joined by +</source>
        <translation>Вирівнювання виміряних точок перед порівнянням: none, shift, rigid або деякі з x, y, turn, з'єднані знаком +</translation>
    </message>
    <message>
        <source>Findings about the measurement that are accepted by name</source>
        <translation>Зауваження щодо вимірювання, прийняті поіменно</translation>
    </message>
    <message>
        <source>What separates form from scatter: none, mean:5, mean:1,2,3,2,1, gauss:MM or auto</source>
        <translation>Що відділяє форму від розсіювання: none, mean:5, mean:1,2,3,2,1, gauss:MM або auto</translation>
    </message>
    <message>
        <source>How the path answers a deviation</source>
        <translation>Як траєкторія відповідає на відхилення</translation>
    </message>
    <message>
        <source>TOML file with tool, material, machine and stock, kept in the document</source>
        <translation>Файл TOML з інструментом, матеріалом, верстатом і заготовкою, зберігається в документі</translation>
    </message>
    <message>
        <source>Correct again in the model until the error to expect is at most this; 0: only once</source>
        <translation>Коригувати в моделі далі, доки очікувана похибка не перевищує цього; 0: лише раз</translation>
    </message>
    <message>
        <source>Depth along the normal that the measured part was cut at; one, or one a part</source>
        <translation>Глибина вздовж нормалі, на якій різали виміряну деталь; одна або одна на деталь</translation>
    </message>
    <message>
        <source>Depth that the corrected path will cut; 0: that of the measured part</source>
        <translation>Глибина, яку зніматиме скоригована траєкторія; 0: як у виміряної деталі</translation>
    </message>
    <message>
        <source>How deviations are taken: along the normal, or along one axis</source>
        <translation>Як беруться відхилення: вздовж нормалі чи вздовж однієї осі</translation>
    </message>
    <message>
        <source>Smooth along the contour, one value, or one a point</source>
        <translation>Згладжена вздовж контуру, одне значення або по одному на точку</translation>
    </message>
    <message>
        <source>Stock that the path of the measured part left on the nominal</source>
        <translation>Припуск, який траєкторія виміряної деталі залишила на номіналі</translation>
    </message>
    <message>
        <source>Stock that the path leaves on the part: a first cut, before anything is measured</source>
        <translation>Припуск, який траєкторія залишає на деталі: перший прохід до вимірювання</translation>
    </message>
    <message>
        <source>Share of the deviation taken back</source>
        <translation>Частка відхилення, яка знімається</translation>
    </message>
    <message>
        <source>Largest correction; a larger one is refused</source>
        <translation>Найбільша корекція; більша відхиляється</translation>
    </message>
    <message>
        <source>Deviations up to this are left alone</source>
        <translation>Відхилення до цієї величини не чіпаються</translation>
    </message>
    <message>
        <source>Largest share of a contour without points near that is corrected all the same</source>
        <translation>Найбільша частка контуру без точок поблизу, яка все ж коригується</translation>
    </message>
    <message>
        <source>Diameters of other tools of the path, each as 3=16 or ROUGH=16</source>
        <translation>Діаметри інших інструментів траєкторії, кожен як 3=16 або ROUGH=16</translation>
    </message>
    <message>
        <source>Passes that rough along the contour are moved with it</source>
        <translation>Чорнові проходи вздовж контуру зміщуються разом із ним</translation>
    </message>
    <message>
        <source>Largest distance of the path from the exact one</source>
        <translation>Найбільша відстань траєкторії від точної</translation>
    </message>
    <message>
        <source>Moves of the corrected path: as the operation's, only lines, or arcs</source>
        <translation>Рухи скоригованої траєкторії: як в операції, лише відрізки, або дуги</translation>
    </message>
    <message>
        <source>What a path under G41 or G42 is: the contour itself, or the centre path</source>
        <translation>Чим є траєкторія під G41 або G42: самим контуром чи траєкторією центра</translation>
    </message>
    <message>
        <source>Mean deviation</source>
        <translation>Середнє відхилення</translation>
    </message>
    <message>
        <source>Least deviation</source>
        <translation>Найменше відхилення</translation>
    </message>
    <message>
        <source>Greatest deviation</source>
        <translation>Найбільше відхилення</translation>
    </message>
    <message>
        <source>Greatest less least</source>
        <translation>Найбільше мінус найменше</translation>
    </message>
    <message>
        <source>Standard deviation</source>
        <translation>Стандартне відхилення</translation>
    </message>
    <message>
        <source>Standard deviation of what the filter takes for scatter</source>
        <translation>Стандартне відхилення того, що фільтр вважає розсіюванням</translation>
    </message>
    <message>
        <source>Largest distance of the path from the exact offset of the compensated profile</source>
        <translation>Найбільша відстань траєкторії від точної еквідистанти скоригованого профілю</translation>
    </message>
    <message>
        <source>Points left out</source>
        <translation>Вилучені точки</translation>
    </message>
    <message>
        <source>What to know</source>
        <translation>Що варто знати</translation>
    </message>
    <message>
        <source>Measured file of this correction</source>
        <translation>Файл вимірювань цієї корекції</translation>
    </message>
    <message>
        <source>SHA-256 of that file</source>
        <translation>SHA-256 цього файлу</translation>
    </message>
    <message>
        <source>When the correction was made</source>
        <translation>Коли зроблено корекцію</translation>
    </message>
    <message>
        <source>Deviation smoothed over the parts of a series, which is taken out in place of the measured one</source>
        <translation>Відхилення, згладжене за деталями серії, яке усувається замість виміряного</translation>
    </message>
    <message>
        <source>Warnings that were there when the user last looked at the correction</source>
        <translation>Попередження, що були, коли користувач востаннє переглядав корекцію</translation>
    </message>
    <message>
        <source>SHA-256 of the measurement, and of the operation's path when it came</source>
        <translation>SHA-256 вимірювання та траєкторії операції на той час</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Файл</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Точки</translation>
    </message>
    <message>
        <source>Ball radius</source>
        <translation>Радіус кульки</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Одиниця</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Формат</translation>
    </message>
    <message>
        <source>Mapping</source>
        <translation>Відповідність</translation>
    </message>
    <message>
        <source>Probe</source>
        <translation>Щуп</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Деталь</translation>
    </message>
    <message>
        <source>Work offset</source>
        <translation>Нуль деталі</translation>
    </message>
    <message>
        <source>Work offset given</source>
        <translation>Нуль деталі задано</translation>
    </message>
    <message>
        <source>Work rotation</source>
        <translation>Поворот</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>Кількість</translation>
    </message>
    <message>
        <source>Levels</source>
        <translation>Рівні</translation>
    </message>
    <message>
        <source>Has z</source>
        <translation>Має Z</translation>
    </message>
    <message>
        <source>The measured file, kept in the document</source>
        <translation>Файл вимірювань, зберігається в документі</translation>
    </message>
    <message>
        <source>What the coordinates are: points on the surface or centres of the probe's ball</source>
        <translation>Чим є координати: точками на поверхні чи центрами кульки щупа</translation>
    </message>
    <message>
        <source>Radius of the probe's ball where the points are centres; 0: as the file says</source>
        <translation>Радіус кульки щупа, якщо точки є центрами; 0: як каже файл</translation>
    </message>
    <message>
        <source>Unit of length in the file</source>
        <translation>Одиниця довжини у файлі</translation>
    </message>
    <message>
        <source>Format of the file; empty: by its content</source>
        <translation>Формат файлу; порожньо: за вмістом</translation>
    </message>
    <message>
        <source>TOML file that says what the columns of a text file are, kept in the document</source>
        <translation>Файл TOML, що пояснює стовпці текстового файлу, зберігається в документі</translation>
    </message>
    <message>
        <source>TOML file with the calibration of the probe, kept in the document</source>
        <translation>Файл TOML з калібруванням щупа, зберігається в документі</translation>
    </message>
    <message>
        <source>Which of several measured parts in the file, from 1; 0: it holds one</source>
        <translation>Яка з кількох деталей у файлі, від 1; 0: там одна</translation>
    </message>
    <message>
        <source>Origin of the work frame in the frame of the file, mm</source>
        <translation>Початок системи деталі в системі файлу, мм</translation>
    </message>
    <message>
        <source>The work offset holds; otherwise what the file says</source>
        <translation>Діє нуль деталі; інакше те, що каже файл</translation>
    </message>
    <message>
        <source>Turn of the work frame in the frame of the file, anticlockwise</source>
        <translation>Поворот системи деталі в системі файлу, проти годинникової стрілки</translation>
    </message>
    <message>
        <source>Name of the file</source>
        <translation>Назва файлу</translation>
    </message>
    <message>
        <source>SHA-256 of the file</source>
        <translation>SHA-256 файлу</translation>
    </message>
    <message>
        <source>Number of points</source>
        <translation>Кількість точок</translation>
    </message>
    <message>
        <source>Number of Z levels</source>
        <translation>Кількість рівнів Z</translation>
    </message>
    <message>
        <source>The file has a Z coordinate</source>
        <translation>Файл має координату Z</translation>
    </message>
    <message>
        <source>Correction</source>
        <translation>Корекція</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>Показано</translation>
    </message>
    <message>
        <source>Magnification</source>
        <translation>Збільшення</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Розмах</translation>
    </message>
    <message>
        <source>Degree</source>
        <translation>Степінь</translation>
    </message>
    <message>
        <source>Poles</source>
        <translation>Полюси</translation>
    </message>
    <message>
        <source>Contour length</source>
        <translation>Довжина контуру</translation>
    </message>
    <message>
        <source>The dressup whose compensated profile this is</source>
        <translation>Скоригована траєкторія, профілем якої це є</translation>
    </message>
    <message>
        <source>The profile to cut so that the part comes out right, the nominal one, the operation's path along it, the points as measured, those on the surface, or the deviations as lines along the normal</source>
        <translation>Профіль, який треба різати, щоб деталь вийшла правильною, номінальний, траєкторія операції вздовж нього, точки як виміряно, точки на поверхні або відхилення як лінії вздовж нормалі</translation>
    </message>
    <message>
        <source>So many times longer than they are the deviations are drawn</source>
        <translation>У стільки разів довшими рисуються відхилення</translation>
    </message>
    <message>
        <source>Z of the profile</source>
        <translation>Z профілю</translation>
    </message>
    <message>
        <source>Highest degree</source>
        <translation>Найвищий степінь</translation>
    </message>
    <message>
        <source>Number of poles</source>
        <translation>Кількість полюсів</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Довжина</translation>
    </message>
    <message>
        <source>Path tolerance</source>
        <translation>Допуск траєкторії</translation>
    </message>
    <message>
        <source>Batch</source>
        <translation>Пакет</translation>
    </message>
    <message>
        <source>Again</source>
        <translation>Ще раз</translation>
    </message>
    <message>
        <source>Journal</source>
        <translation>Журнал</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Звіт</translation>
    </message>
    <message>
        <source>Jobs to run</source>
        <translation>Завдання до виконання</translation>
    </message>
    <message>
        <source>Also run what an earlier run has done</source>
        <translation>Також те, що вже виконано раніше</translation>
    </message>
    <message>
        <source>Journal of a series</source>
        <translation>Журнал серії</translation>
    </message>
    <message>
        <source>Directory for the report and the table of all parts</source>
        <translation>Каталог для звіту і таблиці всіх деталей</translation>
    </message>
    <message>
        <source>Dialect</source>
        <translation>Діалект</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>Вихід</translation>
    </message>
    <message>
        <source>Points count</source>
        <translation>Кількість точок</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Крок</translation>
    </message>
    <message>
        <source>Curvature</source>
        <translation>Кривина</translation>
    </message>
    <message>
        <source>Touch</source>
        <translation>Дотик</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>Safe z</source>
        <translation>Безпечна Z</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>Зазор</translation>
    </message>
    <message>
        <source>Overtravel</source>
        <translation>Перебіг</translation>
    </message>
    <message>
        <source>Stock</source>
        <translation>Припуск</translation>
    </message>
    <message>
        <source>Free width</source>
        <translation>Вільна ширина</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Подача</translation>
    </message>
    <message>
        <source>Positioning feed</source>
        <translation>Подача позиціювання</translation>
    </message>
    <message>
        <source>Probe tool</source>
        <translation>Номер щупа</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Протокол</translation>
    </message>
    <message>
        <source>Control that runs it</source>
        <translation>ЧПК, на якому виконується</translation>
    </message>
    <message>
        <source>Measuring program to write</source>
        <translation>Вимірювальна програма для запису</translation>
    </message>
    <message>
        <source>Radius at which the probe triggers, as calibrated</source>
        <translation>Радіус спрацювання щупа за калібруванням</translation>
    </message>
    <message>
        <source>Number of points; 0: by their distance</source>
        <translation>Кількість точок; 0: за їх кроком</translation>
    </message>
    <message>
        <source>Distance of points along the contour</source>
        <translation>Відстань між точками вздовж контуру</translation>
    </message>
    <message>
        <source>Denser where the contour bends</source>
        <translation>Густіше там, де контур згинається</translation>
    </message>
    <message>
        <source>Along an axis where the slope allows it, always along an axis, or along the normal</source>
        <translation>Вздовж осі, де дозволяє нахил, завжди вздовж осі або вздовж нормалі</translation>
    </message>
    <message>
        <source>Height to measure at</source>
        <translation>Висота вимірювання</translation>
    </message>
    <message>
        <source>Height at which the probe passes over everything</source>
        <translation>Висота, на якій щуп проходить над усім</translation>
    </message>
    <message>
        <source>Distance from which a touch begins</source>
        <translation>Відстань, з якої починається дотик</translation>
    </message>
    <message>
        <source>How far behind the surface a touch gives up</source>
        <translation>Як далеко за поверхнею дотик припиняється</translation>
    </message>
    <message>
        <source>Stock that is still on the contour</source>
        <translation>Припуск, який ще лишився на контурі</translation>
    </message>
    <message>
        <source>How far beside the contour it is free; 0: everywhere</source>
        <translation>Наскільки вільно біля контуру; 0: усюди</translation>
    </message>
    <message>
        <source>Contour to measure, where it is not the operation's own</source>
        <translation>Контур для вимірювання, якщо він не з операції</translation>
    </message>
    <message>
        <source>Feed of the touch</source>
        <translation>Подача дотику</translation>
    </message>
    <message>
        <source>Feed of moves at measuring height</source>
        <translation>Подача рухів на висоті вимірювання</translation>
    </message>
    <message>
        <source>Number of the probe in the magazine; 0: it is in use</source>
        <translation>Номер щупа в магазині; 0: він уже встановлений</translation>
    </message>
    <message>
        <source>Name of the file the control writes; empty: as usual</source>
        <translation>Назва файлу, який пише ЧПК; порожньо: звичайна</translation>
    </message>
    <message>
        <source>Show picture</source>
        <translation>Показати зображення</translation>
    </message>
    <message>
        <source>Automatic magnification</source>
        <translation>Автоматичне збільшення</translation>
    </message>
    <message>
        <source>Upper limit</source>
        <translation>Верхнє відхилення</translation>
    </message>
    <message>
        <source>Lower limit</source>
        <translation>Нижнє відхилення</translation>
    </message>
    <message>
        <source>Material left</source>
        <translation>Залишений матеріал</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>Стінка</translation>
    </message>
    <message>
        <source>Whiskers</source>
        <translation>Лінії відхилень</translation>
    </message>
    <message>
        <source>Band</source>
        <translation>Смуга</translation>
    </message>
    <message>
        <source>Profiles</source>
        <translation>Профілі</translation>
    </message>
    <message>
        <source>Paths</source>
        <translation>Траєкторії</translation>
    </message>
    <message>
        <source>Rejected points</source>
        <translation>Відкинуті точки</translation>
    </message>
    <message>
        <source>Legend</source>
        <translation>Легенда</translation>
    </message>
    <message>
        <source>Show the deviations in the 3-D view</source>
        <translation>Показати відхилення у тривимірному вигляді</translation>
    </message>
    <message>
        <source>Deviations and the part's size decide how much larger deviations are drawn</source>
        <translation>Відхилення й розмір деталі визначають, наскільки більшими рисуються відхилення</translation>
    </message>
    <message>
        <source>So many times longer than they are deviations and differences are drawn, as far as it turns no contour inside out</source>
        <translation>У стільки разів довшими рисуються відхилення й різниці, доки це не вивертає контуру</translation>
    </message>
    <message>
        <source>Larger deviations are out of tolerance: too much material is left</source>
        <translation>Більші відхилення поза допуском: залишено забагато матеріалу</translation>
    </message>
    <message>
        <source>Smaller deviations are out of tolerance: too much is cut away</source>
        <translation>Менші відхилення поза допуском: зрізано забагато</translation>
    </message>
    <message>
        <source>Colour of material left; measuring machines' programs show it red</source>
        <translation>Колір залишеного матеріалу; програми вимірювальних машин показують його червоним</translation>
    </message>
    <message>
        <source>Show the deviation as the colour of the wall itself</source>
        <translation>Показати відхилення кольором самої стінки</translation>
    </message>
    <message>
        <source>Show each deviation as a line</source>
        <translation>Показати кожне відхилення лінією</translation>
    </message>
    <message>
        <source>Show the tolerance band</source>
        <translation>Показати смугу допуску</translation>
    </message>
    <message>
        <source>Show nominal and compensated profile</source>
        <translation>Показати номінальний і скоригований профілі</translation>
    </message>
    <message>
        <source>Show the path before and after</source>
        <translation>Показати траєкторію до і після</translation>
    </message>
    <message>
        <source>Mark points that are left out</source>
        <translation>Позначити вилучені точки</translation>
    </message>
    <message>
        <source>Show what the colours mean</source>
        <translation>Показати, що означають кольори</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Програма</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Виміряно</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Частка</translation>
    </message>
    <message>
        <source>NC program that cut the measured part</source>
        <translation>Програма ЧПК, якою оброблено виміряну деталь</translation>
    </message>
    <message>
        <source>Diameter of the cutter</source>
        <translation>Діаметр фрези</translation>
    </message>
    <message>
        <source>Contour the part should have: a drawing, or the first program; empty: the program's</source>
        <translation>Контур, який має бути: креслення або перша програма; порожньо: з програми</translation>
    </message>
    <message>
        <source>Measured points, one file a part; deviations of several parts are averaged</source>
        <translation>Виміряні точки, один файл на деталь; відхилення кількох деталей усереднюються</translation>
    </message>
    <message>
        <source>Moves of the corrected program: as the program's, only lines, arcs, or NURBS</source>
        <translation>Рухи скоригованої програми: як у програмі, лише відрізки, дуги або NURBS</translation>
    </message>
    <message>
        <source>Corrected program to write</source>
        <translation>Скоригована програма для запису</translation>
    </message>
    <message>
        <source>Directory for the report; empty: none</source>
        <translation>Каталог для звіту; порожньо: без звіту</translation>
    </message>
    <message>
        <source>Record the part in the journal of its series</source>
        <translation>Записати деталь у журнал її серії</translation>
    </message>
    <message>
        <source>NC program that finishes the part</source>
        <translation>Програма ЧПК, що завершує деталь</translation>
    </message>
    <message>
        <source>Whole allowance over the finished contour</source>
        <translation>Увесь припуск над готовим контуром</translation>
    </message>
    <message>
        <source>Share of the allowance that the first cut takes</source>
        <translation>Частка припуску, яку знімає перший прохід</translation>
    </message>
    <message>
        <source>Program of the first cut</source>
        <translation>Програма першого проходу</translation>
    </message>
    <message>
        <source>Tool, material, machine and stock</source>
        <translation>Інструмент, матеріал, верстат і заготовка</translation>
    </message>
    <message>
        <source>Errors and the part's size decide how much larger errors are drawn</source>
        <translation>Похибки й розмір деталі визначають, наскільки більшими рисуються похибки</translation>
    </message>
    <message>
        <source>So many times larger errors are drawn</source>
        <translation>У стільки разів більшими рисуються похибки</translation>
    </message>
    <message>
        <source>Directory for the report with all signals</source>
        <translation>Каталог для звіту з усіма сигналами</translation>
    </message>
</context>
<context>
    <name>Millcorr</name>
    <message>
        <source>auto</source>
        <translation>автоматично</translation>
    </message>
    <message>
        <source>left</source>
        <translation>ліворуч</translation>
    </message>
    <message>
        <source>right</source>
        <translation>праворуч</translation>
    </message>
    <message>
        <source>mirror</source>
        <translation>дзеркально</translation>
    </message>
    <message>
        <source>transfer</source>
        <translation>передача</translation>
    </message>
    <message>
        <source>combined</source>
        <translation>комбінований</translation>
    </message>
    <message>
        <source>predicted</source>
        <translation>прогноз</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>нормаль</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>smooth</source>
        <translation>згладжена</translation>
    </message>
    <message>
        <source>one</source>
        <translation>одна</translation>
    </message>
    <message>
        <source>points</source>
        <translation>точки</translation>
    </message>
    <message>
        <source>keep</source>
        <translation>зберегти</translation>
    </message>
    <message>
        <source>lines</source>
        <translation>відрізки</translation>
    </message>
    <message>
        <source>arcs</source>
        <translation>дуги</translation>
    </message>
    <message>
        <source>nurbs</source>
        <translation>NURBS</translation>
    </message>
    <message>
        <source>contour</source>
        <translation>контур</translation>
    </message>
    <message>
        <source>wear</source>
        <translation>знос</translation>
    </message>
    <message>
        <source>the tool controller's</source>
        <translation>контролера інструмента</translation>
    </message>
    <message>
        <source>only once</source>
        <translation>лише раз</translation>
    </message>
    <message>
        <source>that of the measured part</source>
        <translation>як у виміряної деталі</translation>
    </message>
    <message>
        <source>contact</source>
        <translation>контактні точки</translation>
    </message>
    <message>
        <source>centre</source>
        <translation>центри</translation>
    </message>
    <message>
        <source>axis</source>
        <translation>вісь</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>мм</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>дюйм</translation>
    </message>
    <message>
        <source>as the file says</source>
        <translation>як каже файл</translation>
    </message>
    <message>
        <source>the only one</source>
        <translation>єдина</translation>
    </message>
    <message>
        <source>µm</source>
        <translation>мкм</translation>
    </message>
    <message>
        <source>in</source>
        <translation>дюйм</translation>
    </message>
    <message>
        <source>thou</source>
        <translation>мілідюйм</translation>
    </message>
    <message>
        <source>Reading points</source>
        <translation>Читання точок</translation>
    </message>
    <message>
        <source>Reading the program</source>
        <translation>Читання програми</translation>
    </message>
    <message>
        <source>Best fit</source>
        <translation>Вирівнювання</translation>
    </message>
    <message>
        <source>Deviations</source>
        <translation>Відхилення</translation>
    </message>
    <message>
        <source>Looking for doubts</source>
        <translation>Пошук сумнівів</translation>
    </message>
    <message>
        <source>Separating form from scatter</source>
        <translation>Відділення форми від розсіювання</translation>
    </message>
    <message>
        <source>Cutting in the model</source>
        <translation>Різання в моделі</translation>
    </message>
    <message>
        <source>Laying and proving the path</source>
        <translation>Побудова і перевірка траєкторії</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>Рисування</translation>
    </message>
    <message>
        <source>Job</source>
        <translation>Завдання</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Стан</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Час</translation>
    </message>
    <message>
        <source>Told</source>
        <translation>Повідомлення</translation>
    </message>
    <message>
        <source>Series</source>
        <translation>Серія</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Деталь</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Виміряно</translation>
    </message>
    <message>
        <source>Mean, {}</source>
        <translation>Середнє, {}</translation>
    </message>
    <message>
        <source>Std. deviation, {}</source>
        <translation>Станд. відхилення, {}</translation>
    </message>
    <message>
        <source>Height, {}</source>
        <translation>Розмах, {}</translation>
    </message>
    <message>
        <source>Correction, {}</source>
        <translation>Корекція, {}</translation>
    </message>
    <message>
        <source>Decision</source>
        <translation>Рішення</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Запустити</translation>
    </message>
    <message>
        <source>Write report</source>
        <translation>Записати звіт</translation>
    </message>
    <message>
        <source>Batches (*.toml);;All files (*)</source>
        <translation>Пакети (*.toml);;Усі файли (*)</translation>
    </message>
    <message>
        <source>Journals (*.journal);;All files (*)</source>
        <translation>Журнали (*.journal);;Усі файли (*)</translation>
    </message>
    <message>
        <source>done before</source>
        <translation>виконано раніше</translation>
    </message>
    <message>
        <source>done</source>
        <translation>виконано</translation>
    </message>
    <message>
        <source>Batch</source>
        <translation>Пакет</translation>
    </message>
    <message>
        <source>failed ({})</source>
        <translation>не вдалося ({})</translation>
    </message>
    <message>
        <source>History of parts</source>
        <translation>Історія деталей</translation>
    </message>
    <message>
        <source>Journal</source>
        <translation>Журнал</translation>
    </message>
    <message>
        <source>Show as plot</source>
        <translation>Показати графіком</translation>
    </message>
    <message>
        <source>{} of {} jobs</source>
        <translation>{} з {} завдань</translation>
    </message>
    <message>
        <source>Stopped; run it again to go on</source>
        <translation>Зупинено; запустіть ще раз, щоб продовжити</translation>
    </message>
    <message>
        <source>waits</source>
        <translation>чекає</translation>
    </message>
    <message>
        <source>Jobs done: {} of {}</source>
        <translation>Завдань виконано: {} із {}</translation>
    </message>
    <message>
        <source>Done in an earlier run: {}</source>
        <translation>Виконано в попередньому запуску: {}</translation>
    </message>
    <message>
        <source>Failed: {}</source>
        <translation>Не вдалося: {}</translation>
    </message>
    <message>
        <source>the open task ended: OK or Cancel</source>
        <translation>завершити відкрите завдання: OK або Скасувати</translation>
    </message>
    <message>
        <source>Needs:</source>
        <translation>Потрібно:</translation>
    </message>
    <message>
        <source>the operation's own contour</source>
        <translation>власний контур операції</translation>
    </message>
    <message>
        <source>Compensated toolpath</source>
        <translation>Скоригована траєкторія</translation>
    </message>
    <message>
        <source>Measured parts</source>
        <translation>Виміряні деталі</translation>
    </message>
    <message>
        <source>Measured part</source>
        <translation>Виміряна деталь</translation>
    </message>
    <message>
        <source>Oldest first. Each part was cut with the path that those before it gave; what is not ticked counts for nothing.</source>
        <translation>Від найстарішої. Кожну деталь фрезеровано за траєкторією, яку дали попередні; непозначене не враховується.</translation>
    </message>
    <message>
        <source>&amp;Import file…</source>
        <translation>&amp;Імпортувати файл…</translation>
    </message>
    <message>
        <source>Point at a whisker to see its point; click to keep it.</source>
        <translation>Наведіть на лінію, щоб побачити її точку; клацніть, щоб залишити.</translation>
    </message>
    <message>
        <source>Correction</source>
        <translation>Корекція</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Метод</translation>
    </message>
    <message>
        <source>More settings</source>
        <translation>Додаткові налаштування</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Зображення</translation>
    </message>
    <message>
        <source>none: only make the path exact</source>
        <translation>немає: лише уточнити траєкторію</translation>
    </message>
    <message>
        <source>no further part</source>
        <translation>жодної нової деталі</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Додати</translation>
    </message>
    <message>
        <source>It is right as it is</source>
        <translation>Так правильно</translation>
    </message>
    <message>
        <source>not a number</source>
        <translation>не число</translation>
    </message>
    <message>
        <source>points on the surface (contact)</source>
        <translation>точки на поверхні (контакт)</translation>
    </message>
    <message>
        <source>centres of the probe's ball</source>
        <translation>центри кульки щупа</translation>
    </message>
    <message>
        <source>ball centres that the control shifted along an axis</source>
        <translation>центри кульки, які ЧПК змістило вздовж осі</translation>
    </message>
    <message>
        <source>mirror: take back what was measured</source>
        <translation>дзеркально: зняти те, що виміряно</translation>
    </message>
    <message>
        <source>transfer: by how the machine gives way</source>
        <translation>передача: за тим, як піддається верстат</translation>
    </message>
    <message>
        <source>combined: one or two touches, and a model of the machine</source>
        <translation>комбінований: один або два дотики і модель верстата</translation>
    </message>
    <message>
        <source>predicted: by the model alone, before anything is measured</source>
        <translation>прогноз: лише за моделлю, до будь-яких вимірювань</translation>
    </message>
    <message>
        <source>as the operation's</source>
        <translation>як в операції</translation>
    </message>
    <message>
        <source>blue, undercut red</source>
        <translation>синій, підріз червоний</translation>
    </message>
    <message>
        <source>red, undercut blue</source>
        <translation>червоний, підріз синій</translation>
    </message>
    <message>
        <source>none</source>
        <translation>без</translation>
    </message>
    <message>
        <source>shift</source>
        <translation>зсув</translation>
    </message>
    <message>
        <source>rigid</source>
        <translation>зсув і поворот</translation>
    </message>
    <message>
        <source>none; several separated by ;</source>
        <translation>немає; кілька через ;</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>виміряно</translation>
    </message>
    <message>
        <source>expected</source>
        <translation>очікується</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Середнє</translation>
    </message>
    <message>
        <source>Mean deviation; positive where material is left</source>
        <translation>Середнє відхилення; додатне там, де лишився матеріал</translation>
    </message>
    <message>
        <source>Least</source>
        <translation>Найменше</translation>
    </message>
    <message>
        <source>Deepest undercut</source>
        <translation>Найглибший підріз</translation>
    </message>
    <message>
        <source>Greatest</source>
        <translation>Найбільше</translation>
    </message>
    <message>
        <source>Most material left</source>
        <translation>Найбільше залишеного матеріалу</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Розмах</translation>
    </message>
    <message>
        <source>Greatest less least</source>
        <translation>Найбільше мінус найменше</translation>
    </message>
    <message>
        <source>Std. dev.</source>
        <translation>Станд. відх.</translation>
    </message>
    <message>
        <source>Spread of deviations about their mean</source>
        <translation>Розкид відхилень навколо середнього</translation>
    </message>
    <message>
        <source>Scatter</source>
        <translation>Розсіювання</translation>
    </message>
    <message>
        <source>Standard deviation of what does not repeat and is therefore not corrected</source>
        <translation>Стандартне відхилення того, що не повторюється і тому не коригується</translation>
    </message>
    <message>
        <source>Largest correction</source>
        <translation>Найбільша корекція</translation>
    </message>
    <message>
        <source>Farthest that the profile to cut lies from the nominal</source>
        <translation>Як далеко профіль для різання відходить від номіналу</translation>
    </message>
    <message>
        <source>Path error before</source>
        <translation>Похибка траєкторії до</translation>
    </message>
    <message>
        <source>How far the operation's own path is off the exact one</source>
        <translation>Наскільки траєкторія операції відходить від точної</translation>
    </message>
    <message>
        <source>Path error after</source>
        <translation>Похибка траєкторії після</translation>
    </message>
    <message>
        <source>How far the corrected path is off the exact one, read back from the finished path</source>
        <translation>Наскільки скоригована траєкторія відходить від точної, прочитано з готової траєкторії</translation>
    </message>
    <message>
        <source>Points used</source>
        <translation>Використані точки</translation>
    </message>
    <message>
        <source>Points used, of those in the file</source>
        <translation>Використані точки з тих, що у файлі</translation>
    </message>
    <message>
        <source>Points left out</source>
        <translation>Вилучені точки</translation>
    </message>
    <message>
        <source>Each is marked in the picture, with its reason</source>
        <translation>Кожну позначено на зображенні, з причиною</translation>
    </message>
    <message>
        <source>Settings (*.toml);;All files (*)</source>
        <translation>Налаштування (*.toml);;Усі файли (*)</translation>
    </message>
    <message>
        <source>Choose</source>
        <translation>Вибрати</translation>
    </message>
    <message>
        <source>not used</source>
        <translation>не використано</translation>
    </message>
    <message>
        <source>no file yet</source>
        <translation>ще немає файлу</translation>
    </message>
    <message>
        <source>Meaning of column {}</source>
        <translation>Значення стовпця {}</translation>
    </message>
    <message>
        <source>Writing</source>
        <translation>Запис</translation>
    </message>
    <message>
        <source>Stopped; nothing was written</source>
        <translation>Зупинено; нічого не записано</translation>
    </message>
    <message>
        <source>Needs: {}</source>
        <translation>Потрібно: {}</translation>
    </message>
    <message>
        <source>More in the documentation</source>
        <translation>Докладніше в документації</translation>
    </message>
    <message>
        <source>Millcorr help</source>
        <translation>Довідка Millcorr</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Назад</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Зміст</translation>
    </message>
    <message>
        <source>Import measurement</source>
        <translation>Імпорт вимірювання</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Файл</translation>
    </message>
    <message>
        <source>file of a CMM, a probe log, or a table of points</source>
        <translation>файл КВМ, журнал щупа або таблиця точок</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>&amp;Огляд…</translation>
    </message>
    <message>
        <source>&amp;More</source>
        <translation>&amp;Більше</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Імпортувати</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Скасувати</translation>
    </message>
    <message>
        <source>Measured points</source>
        <translation>Виміряні точки</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Усі файли (*)</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Читання</translation>
    </message>
    <message>
        <source>by its content</source>
        <translation>за вмістом</translation>
    </message>
    <message>
        <source>Points: {}, heights: {}. {} {}. Format: {}, unit in the file: {}</source>
        <translation>Точки: {}, рівні: {}. {} {}. Формат: {}, одиниця у файлі: {}</translation>
    </message>
    <message>
        <source>Not imported, see the report view</source>
        <translation>Не імпортовано, див. вікно звіту</translation>
    </message>
    <message>
        <source>Origin of the work frame in the file's, {}</source>
        <translation>Початок системи деталі в системі файлу, {}</translation>
    </message>
    <message>
        <source>nominal profile</source>
        <translation>номінальний профіль</translation>
    </message>
    <message>
        <source>profile to cut</source>
        <translation>профіль для різання</translation>
    </message>
    <message>
        <source>tolerance band</source>
        <translation>смуга допуску</translation>
    </message>
    <message>
        <source>path before</source>
        <translation>траєкторія до</translation>
    </message>
    <message>
        <source>corrected path</source>
        <translation>скоригована траєкторія</translation>
    </message>
    <message>
        <source>points left out</source>
        <translation>вилучені точки</translation>
    </message>
    <message>
        <source>in tolerance</source>
        <translation>у допуску</translation>
    </message>
    <message>
        <source>material left</source>
        <translation>залишок матеріалу</translation>
    </message>
    <message>
        <source>undercut</source>
        <translation>підріз</translation>
    </message>
    <message>
        <source>Deviations {}:1</source>
        <translation>Відхилення {}:1</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>автоматично</translation>
    </message>
    <message>
        <source>no points near</source>
        <translation>поблизу немає точок</translation>
    </message>
    <message>
        <source>the largest possible</source>
        <translation>найбільше можливе</translation>
    </message>
    <message>
        <source>(the largest of every {})</source>
        <translation>(найбільші з кожних {})</translation>
    </message>
    <message>
        <source>Drawn at {:.4g}:1: more would turn the contour inside out.</source>
        <translation>Рисується {:.4g}:1: більше вивернуло б контур.</translation>
    </message>
    <message>
        <source>Run in LinuxCNC's own interpreter. Moves between touches are unprotected.</source>
        <translation>Виконано у власному інтерпретаторі LinuxCNC. Рухи між дотиками не захищені.</translation>
    </message>
    <message>
        <source>Run in LinuxCNC's own interpreter. Moves between touches stop at contact. Prefer it.</source>
        <translation>Виконано у власному інтерпретаторі LinuxCNC. Рухи між дотиками зупиняються при контакті. Кращий варіант.</translation>
    </message>
    <message>
        <source>Run in an interpreter written after GRBL's documentation. Moves between touches are unprotected.</source>
        <translation>Виконано в інтерпретаторі, написаному за документацією GRBL. Рухи між дотиками не захищені.</translation>
    </message>
    <message>
        <source>Run in an interpreter written after Renishaw's description of its cycles; result variables compared with public tables.</source>
        <translation>Виконано в інтерпретаторі за описом циклів Renishaw; змінні результатів звірено з відкритими таблицями.</translation>
    </message>
    <message>
        <source>Run in an interpreter written after public descriptions. No manual with the names of the arguments was at hand: compare with yours.</source>
        <translation>Виконано в інтерпретаторі за відкритими описами. Посібника з назвами аргументів не було: звірте зі своїм.</translation>
    </message>
    <message>
        <source>Run in an interpreter written after the description of TCH PROBE cycle 3.</source>
        <translation>Виконано в інтерпретаторі за описом циклу 3 TCH PROBE.</translation>
    </message>
    <message>
        <source>Run in an interpreter written after the programming manual of MEAS.</source>
        <translation>Виконано в інтерпретаторі за посібником з програмування MEAS.</translation>
    </message>
    <message>
        <source>Write program</source>
        <translation>Записати програму</translation>
    </message>
    <message>
        <source>by their distance</source>
        <translation>за їхньою відстанню</translation>
    </message>
    <message>
        <source>by their number</source>
        <translation>за їх кількістю</translation>
    </message>
    <message>
        <source>everywhere</source>
        <translation>усюди</translation>
    </message>
    <message>
        <source>it is in use</source>
        <translation>він уже у шпинделі</translation>
    </message>
    <message>
        <source>Measuring program</source>
        <translation>Вимірювальна програма</translation>
    </message>
    <message>
        <source>No program of millcorr has run on a real machine. Run the first one above the part, then with the feed override low and a hand on feed hold.</source>
        <translation>Жодна програма millcorr не виконувалась на справжньому верстаті. Першу виконайте над деталлю, потім з малою подачею і рукою на зупинці подачі.</translation>
    </message>
    <message>
        <source>Control</source>
        <translation>Система ЧПК</translation>
    </message>
    <message>
        <source>Room</source>
        <translation>Простір</translation>
    </message>
    <message>
        <source>Probe and points on {}</source>
        <translation>Щуп і точки на {}</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>одиниця</translation>
    </message>
    <message>
        <source>radius</source>
        <translation>радіус</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>система координат</translation>
    </message>
    <message>
        <source>stated</source>
        <translation>вказано у файлі</translation>
    </message>
    <message>
        <source>said</source>
        <translation>задано вами</translation>
    </message>
    <message>
        <source>inferred</source>
        <translation>виведено</translation>
    </message>
    <message>
        <source>assumed</source>
        <translation>припущено</translation>
    </message>
    <message>
        <source>Millcorr needs Python packages that FreeCAD's Python does not have: {}.

They can be installed into {}, for FreeCAD alone, from the network.</source>
        <translation>Millcorr потребує пакетів Python, яких немає в Python програми FreeCAD: {}.

Їх можна встановити з мережі в {}, лише для FreeCAD.</translation>
    </message>
    <message>
        <source>They could not be installed: {}

In a terminal, this does the same:
{}</source>
        <translation>Їх не вдалося встановити: {}

У терміналі те саме робить:
{}</translation>
    </message>
    <message>
        <source>Python packages, which a dialog offers to install: {}</source>
        <translation>пакети Python, які пропонує встановити вікно: {}</translation>
    </message>
    <message>
        <source>Install</source>
        <translation>Встановити</translation>
    </message>
    <message>
        <source>Installing…</source>
        <translation>Встановлення…</translation>
    </message>
    <message>
        <source>Installed. Start FreeCAD again to use them.</source>
        <translation>Встановлено. Запустіть FreeCAD знову, щоб їх використати.</translation>
    </message>
    <message>
        <source>On Debian and Ubuntu pip comes with: apt install python3-pip</source>
        <translation>У Debian та Ubuntu pip дає команда: apt install python3-pip</translation>
    </message>
    <message>
        <source>Stopped: change a setting to compute again</source>
        <translation>Зупинено: змініть налаштування, щоб обчислити знову</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Зупинити</translation>
    </message>
    <message>
        <source>Computing</source>
        <translation>Обчислення</translation>
    </message>
    <message>
        <source>Internal error, see the report view</source>
        <translation>Внутрішня помилка, див. вікно звіту</translation>
    </message>
    <message>
        <source>Close the open task first</source>
        <translation>Спершу закрийте відкрите завдання</translation>
    </message>
    <message>
        <source>Not possible yet: see {}</source>
        <translation>Поки неможливо: див. {}</translation>
    </message>
    <message>
        <source>blue</source>
        <translation>синій</translation>
    </message>
    <message>
        <source>red</source>
        <translation>червоний</translation>
    </message>
    <message>
        <source>expected next</source>
        <translation>очікується далі</translation>
    </message>
    <message>
        <source>range of the points</source>
        <translation>діапазон точок</translation>
    </message>
    <message>
        <source>mean and standard deviation</source>
        <translation>середнє і стандартне відхилення</translation>
    </message>
    <message>
        <source>limits</source>
        <translation>межі</translation>
    </message>
    <message>
        <source>program corrected</source>
        <translation>програму скориговано</translation>
    </message>
    <message>
        <source>outlier</source>
        <translation>викид</translation>
    </message>
    <message>
        <source>normal law of the scatter</source>
        <translation>нормальний закон розсіювання</translation>
    </message>
    <message>
        <source>part</source>
        <translation>деталь</translation>
    </message>
    <message>
        <source>arc length s, {}</source>
        <translation>довжина дуги s, {}</translation>
    </message>
    <message>
        <source>uncertainty, k = {:g}</source>
        <translation>невизначеність, k = {:g}</translation>
    </message>
    <message>
        <source>determined part</source>
        <translation>детермінована частина</translation>
    </message>
    <message>
        <source>form, root mean square</source>
        <translation>форма, середнє квадратичне</translation>
    </message>
    <message>
        <source>smoothed, largest</source>
        <translation>згладжене, найбільше</translation>
    </message>
    <message>
        <source>deviation, {}</source>
        <translation>відхилення, {}</translation>
    </message>
    <message>
        <source>Click at a place of the picture or the plot to see its line of the file.</source>
        <translation>Клацніть місце картини або графіка, щоб побачити його рядок файла.</translation>
    </message>
    <message>
        <source>The measured file is no plain text.</source>
        <translation>Файл вимірювання не є простим текстом.</translation>
    </message>
    <message>
        <source>s {0:.{1}f} {2}: measured {3} {5}, expected next {4} {5}</source>
        <translation>s {0:.{1}f} {2}: виміряно {3} {5}, очікується далі {4} {5}</translation>
    </message>
    <message>
        <source>Millcorr plots</source>
        <translation>Графіки Millcorr</translation>
    </message>
    <message>
        <source>Linked to the 3-D view</source>
        <translation>Зв'язано з тривимірним виглядом</translation>
    </message>
    <message>
        <source>What is pointed at in the plot shows in the 3-D view and the other way round; the view follows the zoom of the plot, the plot that of the view</source>
        <translation>На що вказано на графіку, видно у тривимірному вигляді, і навпаки; вигляд іде за масштабом графіка, графік за масштабом вигляду</translation>
    </message>
    <message>
        <source>Measured file</source>
        <translation>Файл вимірювання</translation>
    </message>
    <message>
        <source>Select a compensated toolpath</source>
        <translation>Виберіть скориговану траєкторію</translation>
    </message>
    <message>
        <source>A journal's parts are plotted from the window History of parts</source>
        <translation>Деталі журналу рисує вікно «Історія деталей»</translation>
    </message>
    <message>
        <source>Along the contour</source>
        <translation>Вздовж контуру</translation>
    </message>
    <message>
        <source>Distribution</source>
        <translation>Розподіл</translation>
    </message>
    <message>
        <source>The journal has no part yet</source>
        <translation>У журналі ще немає деталей</translation>
    </message>
    <message>
        <source>{}, parts: {}</source>
        <translation>{}, деталей: {}</translation>
    </message>
    <message>
        <source>{}: nothing was measured</source>
        <translation>{}: нічого не виміряно</translation>
    </message>
    <message>
        <source>NC programs (*.nc *.ngc *.tap *.gcode *.cnc *.mpf *.h *.txt);;All files (*)</source>
        <translation>Програми ЧПК (*.nc *.ngc *.tap *.gcode *.cnc *.mpf *.h *.txt);;Усі файли (*)</translation>
    </message>
    <message>
        <source>Contours (*.step *.stp *.iges *.igs *.brep *.dxf *.json *.nc *.ngc *.tap *.gcode *.cnc *.mpf);;All files (*)</source>
        <translation>Контури (*.step *.stp *.iges *.igs *.brep *.dxf *.json *.nc *.ngc *.tap *.gcode *.cnc *.mpf);;Усі файли (*)</translation>
    </message>
    <message>
        <source>Correct NC program file</source>
        <translation>Коригувати файл програми ЧПК</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Програма</translation>
    </message>
    <message>
        <source>How the file is read</source>
        <translation>Як читається файл</translation>
    </message>
    <message>
        <source>What is written</source>
        <translation>Що записується</translation>
    </message>
    <message>
        <source>Split allowance</source>
        <translation>Поділити припуск</translation>
    </message>
    <message>
        <source>The first cut leaves a part of the allowance. Measure it, then correct the program that finishes the part with the method “transfer”: the part itself has shown how far the machine yields.</source>
        <translation>Перший прохід залишає частину припуску. Виміряйте її, потім скоригуйте програму, що завершує деталь, методом «передача»: деталь сама показала, наскільки піддається верстат.</translation>
    </message>
    <message>
        <source>The program of the first cut is written</source>
        <translation>Програму першого проходу записано</translation>
    </message>
    <message>
        <source>Deviations, {}</source>
        <translation>Відхилення, {}</translation>
    </message>
    <message>
        <source>Set {} to {}</source>
        <translation>Встановити {}: {}</translation>
    </message>
    <message>
        <source>Go to {}</source>
        <translation>Перейти до {}</translation>
    </message>
    <message>
        <source>Switch on {}</source>
        <translation>Увімкнути {}</translation>
    </message>
    <message>
        <source>an operation selected in the tree</source>
        <translation>операція, вибрана в дереві</translation>
    </message>
    <message>
        <source>a compensated toolpath: make one first</source>
        <translation>скоригована траєкторія: спершу створіть її</translation>
    </message>
    <message>
        <source>an open document</source>
        <translation>відкритий документ</translation>
    </message>
    <message>
        <source>a job with an operation, such as a Profile</source>
        <translation>завдання з операцією, наприклад Profile</translation>
    </message>
    <message>
        <source>an operation that stands in a job, without a dressup over it: select the dressup</source>
        <translation>операція в завданні без накладення над нею: виберіть накладення</translation>
    </message>
    <message>
        <source>a compensated toolpath selected in the tree</source>
        <translation>скоригована траєкторія, вибрана в дереві</translation>
    </message>
    <message>
        <source>a compensated toolpath with a measured part</source>
        <translation>скоригована траєкторія з виміряною деталлю</translation>
    </message>
    <message>
        <source>a Profile operation with a path, selected in the tree</source>
        <translation>операція Profile з траєкторією, вибрана в дереві</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>Моделювання</translation>
    </message>
    <message>
        <source>time, s</source>
        <translation>час, с</translation>
    </message>
    <message>
        <source>force</source>
        <translation>сила</translation>
    </message>
    <message>
        <source>engaged arc</source>
        <translation>кут контакту</translation>
    </message>
    <message>
        <source>feed</source>
        <translation>подача</translation>
    </message>
    <message>
        <source>deflection</source>
        <translation>прогин</translation>
    </message>
    <message>
        <source>Setups (*.toml);;All files (*)</source>
        <translation>Налагодження (*.toml);;Усі файли (*)</translation>
    </message>
    <message>
        <source>Name the setup: tool, material, machine and stock, as a TOML file.</source>
        <translation>Вкажіть налагодження: інструмент, матеріал, верстат і заготовку, як файл TOML.</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Відтворити</translation>
    </message>
    <message>
        <source>So many times faster than the machine</source>
        <translation>У стільки разів швидше за верстат</translation>
    </message>
    <message>
        <source>Largest predicted error {} {}</source>
        <translation>Найбільша прогнозована похибка {} {}</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Пауза</translation>
    </message>
    <message>
        <source>{:.2f} s, line {}: </source>
        <translation>{:.2f} с, рядок {}: </translation>
    </message>
    <message>
        <source>, corrected {} {}</source>
        <translation>, скориговано {} {}</translation>
    </message>
    <message>
        <source>&lt;span style='color:#888'&gt;—&lt;/span&gt; commanded path, &lt;span style='color:#c00'&gt;—&lt;/span&gt; machined contour, &lt;span style='color:#2e9a1c'&gt;—&lt;/span&gt; corrected contour, errors {:g}:1</source>
        <translation>&lt;span style='color:#888'&gt;—&lt;/span&gt; задана траєкторія, &lt;span style='color:#c00'&gt;—&lt;/span&gt; оброблений контур, &lt;span style='color:#2e9a1c'&gt;—&lt;/span&gt; скоригований контур, похибки {:g}:1</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Довідка</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Закрити</translation>
    </message>
    <message>
        <source>Open {}</source>
        <translation>Відкрити {}</translation>
    </message>
    <message>
        <source>Constant offset</source>
        <translation>Сталий зсув</translation>
    </message>
    <message>
        <source>What stays whatever the depth, such as a wrong tool radius; known from two depths only</source>
        <translation>Що лишається за будь-якої глибини, наприклад хибний радіус інструмента; відомо лише з двох глибин</translation>
    </message>
    <message>
        <source>MS, mean</source>
        <translation>MS, середнє</translation>
    </message>
    <message>
        <source>Share of the depth removed that the machine yields</source>
        <translation>Частка знятої глибини, на яку піддається верстат</translation>
    </message>
    <message>
        <source>MS, least</source>
        <translation>MS, найменше</translation>
    </message>
    <message>
        <source>Where the machine is stiffest</source>
        <translation>Де верстат найжорсткіший</translation>
    </message>
    <message>
        <source>MS, greatest</source>
        <translation>MS, найбільше</translation>
    </message>
    <message>
        <source>Where the machine yields most</source>
        <translation>Де верстат піддається найбільше</translation>
    </message>
    <message>
        <source>Uncertainty of MS</source>
        <translation>Невизначеність MS</translation>
    </message>
    <message>
        <source>Standard uncertainty at a point</source>
        <translation>Стандартна невизначеність у точці</translation>
    </message>
    <message>
        <source>Next depth</source>
        <translation>Наступна глибина</translation>
    </message>
    <message>
        <source>Depth that the corrected path will find</source>
        <translation>Глибина, яку зустріне скоригована траєкторія</translation>
    </message>
    <message>
        <source>Uncertainty of the correction</source>
        <translation>Невизначеність корекції</translation>
    </message>
    <message>
        <source>Standard uncertainty of where the path is put</source>
        <translation>Стандартна невизначеність положення траєкторії</translation>
    </message>
    <message>
        <source>Transfer function</source>
        <translation>Передавальна функція</translation>
    </message>
    <message>
        <source>The machine yields in proportion to what it cuts. From the depth H of the measured part and its error δ follows the transfer function &lt;b&gt;MS = δ / (H − δ)&lt;/b&gt;; the next path commands &lt;b&gt;H · (1 + MS)&lt;/b&gt;, and removes H. That also holds at another depth, where a mirrored error does not.</source>
        <translation>Верстат піддається пропорційно до того, що знімає. З глибини H виміряної деталі та її похибки δ випливає передавальна функція &lt;b&gt;MS = δ / (H − δ)&lt;/b&gt;; наступна траєкторія задає &lt;b&gt;H · (1 + MS)&lt;/b&gt; і знімає H. Це діє й за іншої глибини, де дзеркальна похибка не діє.</translation>
    </message>
    <message>
        <source>Depths</source>
        <translation>Глибини</translation>
    </message>
    <message>
        <source>Machining system</source>
        <translation>Технологічна система</translation>
    </message>
    <message>
        <source>The first cut leaves a part of the allowance on the finished contour. Measure the part then, import the measurement, and correct with the transfer function: the second cut comes out right.</source>
        <translation>Перший прохід залишає частину припуску на готовому контурі. Потім виміряйте деталь, імпортуйте вимірювання і скоригуйте за передавальною функцією: другий прохід буде правильним.</translation>
    </message>
    <message>
        <source>A program file instead…</source>
        <translation>Натомість файл програми…</translation>
    </message>
    <message>
        <source>The first cut takes {0} {2} and leaves {1} {2}. Its path is within {3} {4} of the exact parallel.</source>
        <translation>Перший прохід знімає {0} {2} і залишає {1} {2}. Його траєкторія в межах {3} {4} від точної еквідистанти.</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Загальне</translation>
    </message>
    <message>
        <source>New corrections</source>
        <translation>Нові корекції</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Фільтр</translation>
    </message>
    <message>
        <source>What separates form from scatter: none, mean:5, mean:1,2,3,2,1, gauss:MM or auto</source>
        <translation>Що відділяє форму від розсіювання: none, mean:5, mean:1,2,3,2,1, gauss:MM або auto</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Коефіцієнт</translation>
    </message>
    <message>
        <source>Share of the deviation taken back</source>
        <translation>Частка відхилення, яка знімається</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Межа</translation>
    </message>
    <message>
        <source>Largest correction; a larger one is refused</source>
        <translation>Найбільша корекція; більша відхиляється</translation>
    </message>
    <message>
        <source>Dead band</source>
        <translation>Зона нечутливості</translation>
    </message>
    <message>
        <source>Deviations up to this are left alone</source>
        <translation>Відхилення до цієї величини не чіпаються</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Допуск</translation>
    </message>
    <message>
        <source>Largest distance of the path from the exact one</source>
        <translation>Найбільша відстань траєкторії від точної</translation>
    </message>
    <message>
        <source>New measurements</source>
        <translation>Нові вимірювання</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Точки</translation>
    </message>
    <message>
        <source>What the coordinates of a measured file are</source>
        <translation>Чим є координати файлу вимірювань</translation>
    </message>
    <message>
        <source>Ball radius</source>
        <translation>Радіус кульки</translation>
    </message>
    <message>
        <source>Radius of the probe's ball; 0: as the file says</source>
        <translation>Радіус кульки щупа; 0: як каже файл</translation>
    </message>
    <message>
        <source>Measuring programs</source>
        <translation>Вимірювальні програми</translation>
    </message>
    <message>
        <source>Control that runs measuring programs</source>
        <translation>ЧПК, на якому виконуються вимірювальні програми</translation>
    </message>
    <message>
        <source>Touch feed</source>
        <translation>Подача дотику</translation>
    </message>
    <message>
        <source>Feed of the touch</source>
        <translation>Подача дотику</translation>
    </message>
    <message>
        <source>Positioning feed</source>
        <translation>Подача позиціювання</translation>
    </message>
    <message>
        <source>Feed of moves at measuring height</source>
        <translation>Подача рухів на висоті вимірювання</translation>
    </message>
    <message>
        <source>Pictures and plots</source>
        <translation>Зображення та графіки</translation>
    </message>
    <message>
        <source>Show the deviations in the 3-D view as soon as a correction is made</source>
        <translation>Показує відхилення у тривимірному вигляді, щойно зроблено корекцію</translation>
    </message>
    <message>
        <source>Show the deviations of a new correction</source>
        <translation>Показувати відхилення нової корекції</translation>
    </message>
    <message>
        <source>Deviations and the part's size decide how much larger deviations are drawn</source>
        <translation>Відхилення й розмір деталі визначають, наскільки більшими рисуються відхилення</translation>
    </message>
    <message>
        <source>Automatic magnification</source>
        <translation>Автоматичне збільшення</translation>
    </message>
    <message>
        <source>Magnification</source>
        <translation>Збільшення</translation>
    </message>
    <message>
        <source>So many times longer than they are deviations are drawn</source>
        <translation>У стільки разів довшими рисуються відхилення</translation>
    </message>
    <message>
        <source>Upper limit</source>
        <translation>Верхнє відхилення</translation>
    </message>
    <message>
        <source>Larger deviations are out of tolerance: too much material is left</source>
        <translation>Більші відхилення поза допуском: залишено забагато матеріалу</translation>
    </message>
    <message>
        <source>Lower limit</source>
        <translation>Нижнє відхилення</translation>
    </message>
    <message>
        <source>Smaller deviations are out of tolerance: too much is cut away</source>
        <translation>Менші відхилення поза допуском: зрізано забагато</translation>
    </message>
    <message>
        <source>Material left</source>
        <translation>Залишений матеріал</translation>
    </message>
    <message>
        <source>Colour of material left; measuring machines' programs show it red</source>
        <translation>Колір залишеного матеріалу; програми вимірювальних машин показують його червоним</translation>
    </message>
    <message>
        <source>Colours of plots</source>
        <translation>Кольори графіків</translation>
    </message>
    <message>
        <source>Light or dark plots</source>
        <translation>Світлі або темні графіки</translation>
    </message>
    <message>
        <source>as the window</source>
        <translation>як вікно</translation>
    </message>
    <message>
        <source>light</source>
        <translation>світлі</translation>
    </message>
    <message>
        <source>dark</source>
        <translation>темні</translation>
    </message>
</context>
<context>
    <name>Millcorr_Report</name>
    <message>
        <source>Directory for the report</source>
        <translation>Каталог для звіту</translation>
    </message>
    <message>
        <source>Export report…</source>
        <translation>Експортувати звіт…</translation>
    </message>
    <message>
        <source>Write the report of the selected compensated toolpath to a directory</source>
        <translation>Записує звіт вибраної скоригованої траєкторії в каталог</translation>
    </message>
    <message>
        <source>Export report</source>
        <translation>Експорт звіту</translation>
    </message>
</context>
<context>
    <name>Millcorr_Profile</name>
    <message>
        <source>Compensated profile</source>
        <translation>Скоригований профіль</translation>
    </message>
    <message>
        <source>Make the profile to cut, as a NURBS for any operation</source>
        <translation>Створює профіль для різання, як NURBS для будь-якої операції</translation>
    </message>
</context>
<context>
    <name>Millcorr_Measurement</name>
    <message>
        <source>Import measurement…</source>
        <translation>Імпортувати вимірювання…</translation>
    </message>
    <message>
        <source>Read the measured points of a part and keep the file in the document</source>
        <translation>Читає виміряні точки деталі й зберігає файл у документі</translation>
    </message>
</context>
<context>
    <name>Millcorr_Dressup</name>
    <message>
        <source>Compensated toolpath…</source>
        <translation>Скоригована траєкторія…</translation>
    </message>
    <message>
        <source>Correct the path of the selected operation from a measured part</source>
        <translation>Коригує траєкторію вибраної операції за виміряною деталлю</translation>
    </message>
</context>
<context>
    <name>Millcorr_Picture</name>
    <message>
        <source>Show deviations</source>
        <translation>Показати відхилення</translation>
    </message>
    <message>
        <source>Show or hide deviations, profiles and paths of the selected compensated toolpath</source>
        <translation>Показує або ховає відхилення, профілі й траєкторії вибраної скоригованої траєкторії</translation>
    </message>
</context>
<context>
    <name>Millcorr_Transfer</name>
    <message>
        <source>Transfer function…</source>
        <translation>Передавальна функція…</translation>
    </message>
    <message>
        <source>Correct by how far the machine yields, from the depth that was cut</source>
        <translation>Коригує за тим, наскільки піддається верстат, з глибини різання</translation>
    </message>
</context>
<context>
    <name>Millcorr_Split</name>
    <message>
        <source>Split allowance…</source>
        <translation>Поділити припуск…</translation>
    </message>
    <message>
        <source>Cut an allowance in two: measure after the first cut, correct the second</source>
        <translation>Ділить припуск на два проходи: виміряти після першого, скоригувати другий</translation>
    </message>
</context>
<context>
    <name>Millcorr_Probe</name>
    <message>
        <source>Measuring program…</source>
        <translation>Вимірювальна програма…</translation>
    </message>
    <message>
        <source>Write a program that measures the selected operation's contour on the machine</source>
        <translation>Записує програму, що вимірює контур вибраної операції на верстаті</translation>
    </message>
</context>
<context>
    <name>Millcorr_Plots</name>
    <message>
        <source>Plots</source>
        <translation>Графіки</translation>
    </message>
    <message>
        <source>Deviations along the contour and their distribution, linked to the 3-D view</source>
        <translation>Відхилення вздовж контуру та їх розподіл, зв'язані з тривимірним виглядом</translation>
    </message>
</context>
<context>
    <name>Millcorr_Simulate</name>
    <message>
        <source>Simulate…</source>
        <translation>Моделювати…</translation>
    </message>
    <message>
        <source>Run the cutter along the selected operation: force, deflection, predicted contour</source>
        <translation>Веде фрезу вздовж вибраної операції: сила, прогин, прогнозований контур</translation>
    </message>
</context>
<context>
    <name>Millcorr_Program</name>
    <message>
        <source>Correct NC program file…</source>
        <translation>Коригувати файл програми ЧПК…</translation>
    </message>
    <message>
        <source>Correct an NC program from a measured part, without any document</source>
        <translation>Коригує програму ЧПК за виміряною деталлю, без документа</translation>
    </message>
</context>
<context>
    <name>Millcorr_Batch</name>
    <message>
        <source>Batch…</source>
        <translation>Пакет…</translation>
    </message>
    <message>
        <source>Run many corrections from one file, in the background</source>
        <translation>Виконує багато корекцій з одного файлу у фоні</translation>
    </message>
</context>
<context>
    <name>Millcorr_History</name>
    <message>
        <source>History of parts…</source>
        <translation>Історія деталей…</translation>
    </message>
    <message>
        <source>Show what the journal of a series holds: parts, corrections, trends</source>
        <translation>Показує вміст журналу серії: деталі, корекції, тренди</translation>
    </message>
</context>
<context>
    <name>Millcorr_Help</name>
    <message>
        <source>Millcorr help</source>
        <translation>Довідка Millcorr</translation>
    </message>
    <message>
        <source>The documentation, page by page</source>
        <translation>Документація, сторінка за сторінкою</translation>
    </message>
</context>
<context>
    <name>Workbench</name>
    <message>
        <source>Millcorr</source>
        <translation>Millcorr</translation>
    </message>
    <message>
        <source>Correct milling toolpaths from measured parts</source>
        <translation>Корекція траєкторій фрезерування за виміряними деталями</translation>
    </message>
    <message>
        <source>Macros</source>
        <translation>Макроси</translation>
    </message>
</context>
<context>
    <name>Millcorr_Macro</name>
    <message>
        <source>Correct document</source>
        <translation>Коригувати документ</translation>
    </message>
    <message>
        <source>Ask for a document and a measured file; write the corrected document, its program and the report beside it</source>
        <translation>Запитує документ і файл вимірювань; записує поруч скоригований документ, його програму і звіт</translation>
    </message>
    <message>
        <source>Correct selected operation</source>
        <translation>Коригувати вибрану операцію</translation>
    </message>
    <message>
        <source>Ask for a measured file and correct the selected operation, or the job's only Profile, with it</source>
        <translation>Запитує файл вимірювань і коригує ним вибрану операцію або єдиний Profile завдання</translation>
    </message>
    <message>
        <source>Measuring program for LinuxCNC</source>
        <translation>Вимірювальна програма для LinuxCNC</translation>
    </message>
    <message>
        <source>Ask for a file and write a measuring program of the selected operation, or of the job's only Profile</source>
        <translation>Запитує файл і записує вимірювальну програму вибраної операції або єдиного Profile завдання</translation>
    </message>
</context>
<context>
    <name>Millcorr_Said</name>
    <message>
        <source>{}: {} {} puts the path on the other side of the contour</source>
        <translation>{}: {} {} переносить траєкторію на інший бік контуру</translation>
    </message>
    <message>
        <source>{}: the operation's base geometry gives no profile; select faces or edges of it in the operation, with processPerimeter or processHoles on</source>
        <translation>{}: базова геометрія операції не дає профілю; виберіть в операції її грані або ребра, з processPerimeter чи processHoles</translation>
    </message>
    <message>
        <source>{}: lines of the pattern {} end on the pocket's walls, and would cut into them once they are corrected; choose the pattern Offset</source>
        <translation>{}: лінії шаблону {} закінчуються на стінках кишені й після корекції врізалися б у них; виберіть шаблон Offset</translation>
    </message>
    <message>
        <source>{}: the operation belongs to no job and has no base geometry</source>
        <translation>{}: операція не належить до жодного завдання і не має базової геометрії</translation>
    </message>
    <message>
        <source>{}: the job has no model</source>
        <translation>{}: завдання не має моделі</translation>
    </message>
    <message>
        <source>{}: set {} to 0, the control holds the radius (UseComp off)</source>
        <translation>{}: установіть {} на 0, радіус враховує система ЧПК (UseComp вимкнено)</translation>
    </message>
    <message>
        <source>{}: a pocket follows faces, and an edge of {} is selected</source>
        <translation>{}: кишеня йде за гранями, а вибрано ребро {}</translation>
    </message>
    <message>
        <source>{}: {}.{} is neither face nor edge</source>
        <translation>{}: {}.{} не є ні гранню, ні ребром</translation>
    </message>
    <message>
        <source>{}: {}.{} is neither level nor vertical; choose a sketch of the contour as Nominal</source>
        <translation>{}: {}.{} не горизонтальна і не вертикальна; виберіть ескіз контуру як номінальний контур</translation>
    </message>
    <message>
        <source>Profile operations</source>
        <translation>операції Profile</translation>
    </message>
    <message>
        <source>operations called {}</source>
        <translation>операції з назвою {}</translation>
    </message>
    <message>
        <source>none</source>
        <translation>жодної</translation>
    </message>
    <message>
        <source>the document has {} {}; its operations are: {}</source>
        <translation>документ має {} {}; його операції: {}</translation>
    </message>
    <message>
        <source>{} belongs to a document that is a file, and to an {}: it records both</source>
        <translation>{} належить до документа, що є файлом, і до {}: воно записує обидва</translation>
    </message>
    <message>
        <source>{}: FreeCAD could not recompute the corrected path</source>
        <translation>{}: FreeCAD не зміг перерахувати скориговану траєкторію</translation>
    </message>
    <message>
        <source>{}: the posted program has no move of this operation</source>
        <translation>{}: виведена програма не має рухів цієї операції</translation>
    </message>
    <message>
        <source>The path error is that of the path itself: the job's post processor gave no program ({}).</source>
        <translation>Похибка траєкторії — це похибка самої траєкторії: постпроцесор завдання не дав програми ({}).</translation>
    </message>
    <message>
        <source>no</source>
        <translation>жодної:</translation>
    </message>
    <message>
        <source>a setting is not possible: {}</source>
        <translation>налаштування неможливе: {}</translation>
    </message>
    <message>
        <source>FreeCAD's post processor {} does not write the path as it is: {}; post with another one</source>
        <translation>постпроцесор FreeCAD {} записує траєкторію не такою, якою вона є: {}; виведіть іншим</translation>
    </message>
    <message>
        <source>what FreeCAD's post processor {} makes is no G-code that can be read back and proven ({}{}): choose a post processor of G-code in the job, as linuxcnc or grbl</source>
        <translation>те, що створює постпроцесор FreeCAD {}, не є G-кодом, який можна прочитати назад і перевірити ({}{}): виберіть у завданні постпроцесор G-коду, наприклад linuxcnc або grbl</translation>
    </message>
    <message>
        <source>{}: the operation has no tool with a diameter; set ToolDiameter</source>
        <translation>{}: операція не має інструмента з діаметром; задайте діаметр інструмента</translation>
    </message>
    <message>
        <source>{}: the tool's diameter is {}; set ToolDiameter</source>
        <translation>{}: діаметр інструмента {}; задайте діаметр інструмента</translation>
    </message>
    <message>
        <source>{} has no shape to take as nominal profile</source>
        <translation>{} не має форми, яку взяти за номінальний профіль</translation>
    </message>
    <message>
        <source>{}: FreeCAD's post processor {} made no program</source>
        <translation>{}: постпроцесор FreeCAD {} не дав програми</translation>
    </message>
    <message>
        <source>{}: FreeCAD's post processor made {} programs; clear SplitOutput</source>
        <translation>{}: постпроцесор FreeCAD дав програм: {}; вимкніть SplitOutput</translation>
    </message>
    <message>
        <source>the dressups of {} form a ring</source>
        <translation>модифікатори {} утворюють кільце</translation>
    </message>
    <message>
        <source>{}: FreeCAD's own post processor {} fails on this job ({}): post with another one</source>
        <translation>{}: власний постпроцесор FreeCAD {} не впорався з цим завданням ({}): виведіть іншим</translation>
    </message>
    <message>
        <source>a profile lies parallel to the XY plane: choose level edges, upright faces, or a sketch of it as Nominal</source>
        <translation>профіль лежить паралельно площині XY: виберіть горизонтальні ребра, вертикальні грані або його ескіз як номінал</translation>
    </message>
    <message>
        <source>select the faces or edges of the profile in the operation, or choose a sketch of it as Nominal</source>
        <translation>виберіть в операції грані чи ребра профілю або його ескіз як номінал</translation>
    </message>
    <message>
        <source>a side face near {} ends neither below nor above in level edges alone: choose a sketch or level edges of the contour as Nominal</source>
        <translation>бічна грань біля {} ні знизу, ні зверху не закінчується лише горизонтальними ребрами: виберіть ескіз або горизонтальні ребра контуру як номінал</translation>
    </message>
    <message>
        <source>an edge of the profile has no length</source>
        <translation>ребро профілю не має довжини</translation>
    </message>
    <message>
        <source>an edge near {} is not level: it runs from Z{:.6f} to Z{:.6f}; {}</source>
        <translation>ребро біля {} не горизонтальне: воно йде від Z{:.6f} до Z{:.6f}; {}</translation>
    </message>
    <message>
        <source>an edge near {} is not level: its poles differ by {} in Z; {}</source>
        <translation>ребро біля {} не горизонтальне: його полюси різняться за Z на {}; {}</translation>
    </message>
    <message>
        <source>the profile has no edge</source>
        <translation>профіль не має ребер</translation>
    </message>
    <message>
        <source>the shape of the profile is empty</source>
        <translation>форма профілю порожня</translation>
    </message>
    <message>
        <source>a face of the profile is not parallel to the XY plane, and the faces close round no solid: choose a sketch or level edges of the contour as Nominal, or save the model as STEP</source>
        <translation>грань профілю не паралельна площині XY, і грані не замикають тіла: виберіть ескіз або горизонтальні ребра контуру як номінал або збережіть модель як STEP</translation>
    </message>
    <message>
        <source>the model is not prismatic: vertical faces do not go all the way round its outline; {}</source>
        <translation>модель не призматична: вертикальні грані не охоплюють усього обрису; {}</translation>
    </message>
    <message>
        <source>the model has no height</source>
        <translation>модель не має висоти</translation>
    </message>
    <message>
        <source>{} edges of the profile meet at {}; leave one way through</source>
        <translation>{} ребер профілю сходяться в {}; залиште один шлях</translation>
    </message>
    <message>
        <source>the model is not prismatic: between {} and {} it stands out of its outline; {}</source>
        <translation>модель не призматична: між {} і {} вона виступає за свій обрис; {}</translation>
    </message>
    <message>
        <source>the model is not prismatic: the side face near {} is not vertical; {}</source>
        <translation>модель не призматична: бічна грань біля {} не вертикальна; {}</translation>
    </message>
    <message>
        <source>unknown setting {}; known are {}</source>
        <translation>невідоме налаштування {}; відомі {}</translation>
    </message>
    <message>
        <source>{}: the dressup has no operation below it</source>
        <translation>{}: під корекцією немає операції</translation>
    </message>
    <message>
        <source>{}: the operation has no path; recompute it</source>
        <translation>{}: операція не має траєкторії; перерахуйте її</translation>
    </message>
    <message>
        <source>{}: the operation cuts along no contour; check its base geometry, and that its FinalDepth lies below the edges that are selected</source>
        <translation>{}: операція не ріже вздовж жодного контуру; перевірте її базову геометрію і чи FinalDepth нижча за вибрані ребра</translation>
    </message>
    <message>
        <source>no such file</source>
        <translation>немає такого файлу</translation>
    </message>
    <message>
        <source>the document has {} objects called {}</source>
        <translation>документ має {} об’єктів з назвою {}</translation>
    </message>
    <message>
        <source>the document is empty or damaged</source>
        <translation>документ порожній або пошкоджений</translation>
    </message>
    <message>
        <source>not a FreeCAD document</source>
        <translation>не документ FreeCAD</translation>
    </message>
    <message>
        <source>the path of {} is not the one the measured part was cut with: the difference between the two counts as an error of the machine; measure a part cut with the path as it is now</source>
        <translation>траєкторія {} не та, з якою різали виміряну деталь: різниця рахується як похибка верстата; виміряйте деталь, вирізану з теперішньою траєкторією</translation>
    </message>
    <message>
        <source>{}: the operation stands in no job</source>
        <translation>{}: операція не стоїть у жодному завданні</translation>
    </message>
    <message>
        <source>{}: a dressup lies on this operation; choose the dressup</source>
        <translation>{}: над цією операцією вже є надбудова; виберіть її</translation>
    </message>
    <message>
        <source>a table of stiffness goes along one contour, the nominal has {}</source>
        <translation>таблиця жорсткості йде вздовж одного контуру, а номінал має {}</translation>
    </message>
    <message>
        <source>{}: its analysis has {} loads, one force on one place is needed</source>
        <translation>{}: аналіз має {} навантажень, потрібна одна сила в одному місці</translation>
    </message>
    <message>
        <source>{}: {} acts on {} places, not on one</source>
        <translation>{}: {} діє на {} місць, а не на одне</translation>
    </message>
    <message>
        <source>{}: {} acts neither along X nor along Y</source>
        <translation>{}: {} не діє ні вздовж X, ні вздовж Y</translation>
    </message>
    <message>
        <source>{}: no displacements of the nodes at {}.{}, calculate it again</source>
        <translation>{}: немає переміщень вузлів у {}.{}, розрахуйте ще раз</translation>
    </message>
    <message>
        <source>{}: the wall moves against its load or not at all</source>
        <translation>{}: стінка рухається проти навантаження або зовсім не рухається</translation>
    </message>
    <message>
        <source>{}: its load at {} is not on the contour</source>
        <translation>{}: навантаження в {} не на контурі</translation>
    </message>
    <message>
        <source>{}: another result loads the place at {} along {}</source>
        <translation>{}: інший результат навантажує місце на {} уздовж {}</translation>
    </message>
    <message>
        <source>{}: the measurement holds no file</source>
        <translation>{}: вимірювання не містить файлу</translation>
    </message>
    <message>
        <source>cannot be read: {}</source>
        <translation>не читається: {}</translation>
    </message>
    <message>
        <source>{} is no Profile or Pocket operation: give the contour with {}</source>
        <translation>{} не є операцією Profile чи Pocket: вкажіть контур через {}</translation>
    </message>
    <message>
        <source>the corrected path has a move that FreeCAD's Path cannot hold: use lines or arcs</source>
        <translation>скоригована траєкторія має рух, якого Path у FreeCAD не вміщає: використайте лінії або дуги</translation>
    </message>
    <message>
        <source>FreeCAD is asked for {}, which it cannot do</source>
        <translation>від FreeCAD вимагається {}, чого він не вміє</translation>
    </message>
    <message>
        <source>{}: the profile has no dressup</source>
        <translation>{}: профіль не має модифікатора</translation>
    </message>
    <message>
        <source>a first cut is made before anything is measured</source>
        <translation>перший прохід роблять, перш ніж щось виміряно</translation>
    </message>
    <message>
        <source>{} is a measured part of {} already: switch it on instead</source>
        <translation>{} вже є виміряною деталлю {}: натомість увімкніть її</translation>
    </message>
    <message>
        <source>the file holds no shape</source>
        <translation>файл не містить форми</translation>
    </message>
    <message>
        <source>the file holds no line or curve</source>
        <translation>файл не містить ліній чи кривих</translation>
    </message>
    <message>
        <source>not a STEP, IGES or BREP file that FreeCAD can read</source>
        <translation>не файл STEP, IGES чи BREP, який FreeCAD може прочитати</translation>
    </message>
    <message>
        <source>this FreeCAD cannot read the DXF file; save the contour as STEP</source>
        <translation>цей FreeCAD не може прочитати файл DXF; збережіть контур як STEP</translation>
    </message>
    <message>
        <source>{}: the nominal of a document comes from an object, a CAD file or a profile.json</source>
        <translation>{}: номінал документа береться з об’єкта, файлу CAD або profile.json</translation>
    </message>
    <message>
        <source>“{}”</source>
        <translation>«{}»</translation>
    </message>
    <message>
        <source>{}, line {}</source>
        <translation>{}, рядок {}</translation>
    </message>
    <message>
        <source>line {}</source>
        <translation>рядок {}</translation>
    </message>
    <message>
        <source>a batch needs a plain Python beside FreeCAD's: none was found on the PATH</source>
        <translation>пакету потрібен окремий Python поруч із FreeCAD: у PATH його не знайдено</translation>
    </message>
    <message>
        <source>{} is not known here: a batch has [defaults] and [[job]]</source>
        <translation>{} тут не відоме: пакет має [defaults] і [[job]]</translation>
    </message>
    <message>
        <source>a batch needs at least one table [[job]]</source>
        <translation>пакету потрібна щонайменше одна таблиця [[job]]</translation>
    </message>
    <message>
        <source>defaults must be a table</source>
        <translation>defaults має бути таблицею</translation>
    </message>
    <message>
        <source>job {}: its name must be one line of text</source>
        <translation>завдання {}: його назва має бути одним рядком тексту</translation>
    </message>
    <message>
        <source>{}: verb is one of {}, not {!r}</source>
        <translation>{}: verb є одним із {}, а не {!r}</translation>
    </message>
    <message>
        <source>no TOML in UTF-8: {}</source>
        <translation>не TOML у UTF-8: {}</translation>
    </message>
    <message>
        <source>defaults: {} is no option</source>
        <translation>defaults: {} не є параметром</translation>
    </message>
    <message>
        <source>{}: {} is no option of {}</source>
        <translation>{}: {} не є параметром {}</translation>
    </message>
    <message>
        <source>{}: {} = {} is not possible</source>
        <translation>{}: {} = {} неможливо</translation>
    </message>
    <message>
        <source>{}: two jobs have this name</source>
        <translation>{}: два завдання мають цю назву</translation>
    </message>
    <message>
        <source>{}: {} and {} both write {}</source>
        <translation>{}: {} і {} обидва записують {}</translation>
    </message>
    <message>
        <source>{}: {} reads {}, which {} writes: jobs run at the same time; make two batches of them</source>
        <translation>{}: {} читає {}, який записує {}: завдання виконуються одночасно; зробіть із них два пакети</translation>
    </message>
    <message>
        <source>alignment: the points do not determine the {}; the fit leaves it alone</source>
        <translation>суміщення: точки не визначають {}; воно лишається як є</translation>
    </message>
    <message>
        <source>alignment: {} of {} points ({:.0f} %) lie off the rest and have no weight in the fit; is a side of the part displaced?</source>
        <translation>суміщення: {} з {} точок ({:.0f} %) лежать осторонь решти й не мають ваги; чи не зміщено якийсь бік деталі?</translation>
    </message>
    <message>
        <source>alignment: the fit hides {:.0f} % of a constant deviation such as a wrong tool or ball radius (mean {} before, {} after)</source>
        <translation>суміщення ховає {:.0f} % сталого відхилення, як від хибного радіуса інструмента чи кульки (середнє {} до, {} після)</translation>
    </message>
    <message>
        <source>alignment: the part measures {:.6f} +- {:.6f} of the profile's size ({} at {}); the scale is not applied: check temperature and unit</source>
        <translation>суміщення: деталь має {:.6f} +- {:.6f} розміру профілю ({} на {}); масштаб не застосовано: перевірте температуру й одиницю</translation>
    </message>
    <message>
        <source>{}: give none, shift, rigid, or some of x, y, turn joined by +; then :zone or :all</source>
        <translation>{}: вкажіть none, shift, rigid або щось із x, y, turn через +; далі :zone або :all</translation>
    </message>
    <message>
        <source>{}: alignment: no end after {} steps, the last one {}</source>
        <translation>{}: суміщення: немає кінця після {} кроків, останній {}</translation>
    </message>
    <message>
        <source>{}: alignment: no minimum zone after {} steps</source>
        <translation>{}: суміщення: немає мінімальної зони після {} кроків</translation>
    </message>
    <message>
        <source>{}: alignment with {} free degrees of freedom needs at least {} points, there are {}</source>
        <translation>{}: суміщення з {} ступенями вільності потребує щонайменше {} точок, є {}</translation>
    </message>
    <message>
        <source>{}: alignment: {:.0f} % of the points stay farther than {} from the profile; check unit, work frame, {} and {}</source>
        <translation>{}: суміщення: {:.0f} % точок лишаються далі ніж {} від профілю; перевірте одиницю, систему деталі, {} і {}</translation>
    </message>
    <message>
        <source>minimum zone: the linear programme failed: {}</source>
        <translation>мінімальна зона: лінійна програма не розв'язалася: {}</translation>
    </message>
    <message>
        <source>{}: alignment: the usable points do not determine the motion</source>
        <translation>{}: суміщення: придатні точки не визначають руху</translation>
    </message>
    <message>
        <source>touched along X or along Y: the slope is too near to 45 degrees to tell, and the file does not say</source>
        <translation>дотик уздовж X чи Y: нахил надто близький до 45 градусів, а файл не каже</translation>
    </message>
    <message>
        <source>touched neither along X nor along Y by the slope of the profile, and the file does not say</source>
        <translation>за нахилом профілю дотик ні вздовж X, ні вздовж Y, а файл не каже</translation>
    </message>
    <message>
        <source>the probe did not travel towards the material here</source>
        <translation>щуп тут не рухався до матеріалу</translation>
    </message>
    <message>
        <source>the points lie {:+.3f} to {} off the profile, by its slope, as if the control had shifted them along X and Y by the radius of a ball of about {}; taken back, {:.0f} of {} of scatter are left: {} with {} from the probe's calibration</source>
        <translation>точки лежать на {:+.3f} до {} від профілю, за його нахилом, ніби система ЧПК змістила їх уздовж X і Y на радіус кульки близько {}; без цього лишається {:.0f} з {} розкиду: {} з {} із калібрування щупа</translation>
    </message>
    <message>
        <source>with the shift by {} along the axis of travel taken back, {} times (1 - cos) of the slope is left, {} of scatter, {} without it</source>
        <translation>якщо зняти зміщення на {} уздовж осі руху, лишається {} разів (1 - cos) нахилу, розкид {}, без нього {}</translation>
    </message>
    <message>
        <source>{}: the points were not shifted along the axis: {}, or centre with {}</source>
        <translation>{}: точки не були зміщені вздовж осі: {}, або centre з {}</translation>
    </message>
    <message>
        <source>{}: {} seems to be about {:.2f}; see its calibration</source>
        <translation>{}: {} має бути близько {:.2f}; див. калібрування</translation>
    </message>
    <message>
        <source>{}: the probe's radius can be taken back at none of {} points, most are {}: check {}, {} and the work frame, or give each point's direction of travel</source>
        <translation>{}: радіус щупа не вдається зняти в жодній з {} точок, більшість: {}; перевірте {}, {} і систему деталі, або вкажіть напрям руху для кожної точки</translation>
    </message>
    <message>
        <source>{}: two radii of a shift need a probe that says the effective one</source>
        <translation>{}: два радіуси зміщення потребують щупа, який називає діючий</translation>
    </message>
    <message>
        <source>{}: the probe travelled along no axis, and control_radius has one radius for X and another one for Y</source>
        <translation>{}: щуп рухався не вздовж осі, а control_radius має різні радіуси для X і Y</translation>
    </message>
    <message>
        <source>the program has no feed move in the XY plane that could follow a contour</source>
        <translation>програма не має руху з подачею в площині XY, який міг би йти за контуром</translation>
    </message>
    <message>
        <source>{}: the ball is as large as the cutter, so its centres lie on the path and do not tell the side of the material: say {} or {}</source>
        <translation>{}: кулька така велика, як фреза, тож її центри лежать на траєкторії і не показують, з якого боку матеріал: вкажіть {} або {}</translation>
    </message>
    <message>
        <source>{}: the points lie on both sides of the path or far from it ({} right and {} left of {}): say {} or {}, and check {}, the unit and the work frame</source>
        <translation>{}: точки лежать по обидва боки траєкторії або далеко від неї ({} праворуч і {} ліворуч із {}): вкажіть {} або {} і перевірте {}, одиницю та систему деталі</translation>
    </message>
    <message>
        <source>{}: the points lie typically {} off the nearest contour that {} cuts: check {}, {}, {}, {}, and the work frame</source>
        <translation>{}: точки лежать зазвичай на {} від найближчого контуру, який ріже {}: перевірте {}, {}, {}, {} і систему деталі</translation>
    </message>
    <message>
        <source>steps of the wall without measured points, down to {}: left as they are</source>
        <translation>уступи стінки без виміряних точок, донизу до {}: лишаються як є</translation>
    </message>
    <message>
        <source>another contour</source>
        <translation>інший контур</translation>
    </message>
    <message>
        <source>{} other contours</source>
        <translation>інші контури: {}</translation>
    </message>
    <message>
        <source>the program cuts {} without measured points: left as it is</source>
        <translation>програма ріже {} без виміряних точок: лишається як є</translation>
    </message>
    <message>
        <source>the program cuts no contour in the XY plane</source>
        <translation>програма не ріже контуру в площині XY</translation>
    </message>
    <message>
        <source>in an inner corner or hollow that the cutter cannot reach</source>
        <translation>у внутрішньому куті чи западині, куди фреза не дістає</translation>
    </message>
    <message>
        <source>farther than {} from the profile</source>
        <translation>далі ніж {} від профілю</translation>
    </message>
    <message>
        <source>beyond the end of the open profile</source>
        <translation>за кінцем незамкненого профілю</translation>
    </message>
    <message>
        <source>at a corner, where the profile has no single normal and the file gives none</source>
        <translation>у куті, де профіль не має однієї нормалі, а файл її не дає</translation>
    </message>
    <message>
        <source>two branches of the profile are equally near and the file gives no normal</source>
        <translation>дві гілки профілю однаково близькі, а файл не дає нормалі</translation>
    </message>
    <message>
        <source>touched on another surface: its own normal is more than 60 degrees off the profile's there</source>
        <translation>дотик до іншої поверхні: власна нормаль відхиляється від нормалі профілю більш ніж на 60 градусів</translation>
    </message>
    <message>
        <source>{}: the program cuts the wall in steps down to {}, and the points have no height: on which of them each lies cannot be told; give the file with its third coordinate</source>
        <translation>{}: програма ріже стінку сходинками до {}, а точки не мають висоти: на якій сходинці кожна, сказати не можна; дайте файл із третьою координатою</translation>
    </message>
    <message>
        <source>{}: the probe's radius is not taken off yet: comparison.ball_radius.contact_known comes first</source>
        <translation>{}: радіус щупа ще не віднято: спершу comparison.ball_radius.contact_known</translation>
    </message>
    <message>
        <source>{}: none of the {} points can be used, most are {}; check unit, work frame, {} and {}</source>
        <translation>{}: жодна з {} точок не придатна, більшість: {}; перевірте одиницю, систему деталі, {} і {}</translation>
    </message>
    <message>
        <source>the offset path does not close near {}: check {} and {}, or give the contour with {}</source>
        <translation>зміщена траєкторія не замикається біля {}: перевірте {} і {}, або дайте контур через {}</translation>
    </message>
    <message>
        <source>the path only circles points at the tool radius {}, or turns tighter than it everywhere: there is no contour; check {} and {}</source>
        <translation>траєкторія лише обходить точки радіусом інструмента {} або всюди крутіша: контуру немає; перевірте {} і {}</translation>
    </message>
    <message>
        <source>the stretch of {} through {} was measured at that place only: {} hold all along it</source>
        <translation>ділянку {} через {} виміряно лише там: {} діє вздовж усієї</translation>
    </message>
    <message>
        <source>a correction of {} is needed at {} ({} points), more than {}; nothing was corrected: look at the place in the report of a check, and say a larger {} if it is right</source>
        <translation>потрібна корекція {} у {} ({} точок), більше ніж {}; нічого не скориговано: подивіться на місце у звіті перевірки й задайте більше {}, якщо все правильно</translation>
    </message>
    <message>
        <source>the stretch of {} near {} has no usable point</source>
        <translation>на ділянці {} біля {} немає придатної точки</translation>
    </message>
    <message>
        <source>between the points the correction swings to {} at {}, more than {}: use a stronger {}; nothing was corrected</source>
        <translation>між точками корекція розгойдується до {} у {}, більше ніж {}: потрібен сильніший {}; нічого не скориговано</translation>
    </message>
    <message>
        <source>{}: it follows its neighbours, {} to {}</source>
        <translation>{}: вона йде за сусідніми, {} до {}</translation>
    </message>
    <message>
        <source> and {} shorter gaps</source>
        <translation> і {} коротших прогалин</translation>
    </message>
    <message>
        <source>no usable point on {} between {} and {}{}: the correction runs straight across or holds its last value</source>
        <translation>немає придатної точки на {} між {} і {}{}: корекція йде навпростець або тримає останнє значення</translation>
    </message>
    <message>
        <source>{}: it is not corrected</source>
        <translation>{}: її не скориговано</translation>
    </message>
    <message>
        <source>{}:{}: this measurement was applied on {} already; cut and measure a new part with the corrected program first</source>
        <translation>{}:{}: це вимірювання вже застосовано {}; спершу обробіть і виміряйте нову деталь за скоригованою програмою</translation>
    </message>
    <message>
        <source>{}:{}: the program was corrected on {}, so it does not show the nominal any more; give the first, uncorrected program or the drawing with {}</source>
        <translation>{}:{}: програму скориговано {}, тож номінал із неї вже не видно; вкажіть першу, нескориговану програму або креслення через {}</translation>
    </message>
    <message>
        <source>line {}: the comment that says which measurement corrected this program is damaged; take the corrected program as it was written</source>
        <translation>рядок {}: коментар про те, яким вимірюванням скориговано програму, пошкоджено; візьміть скориговану програму такою, як її записано</translation>
    </message>
    <message>
        <source>{}: more than {} would hide what is to be corrected</source>
        <translation>{}: більше ніж {} сховало б те, що слід скоригувати</translation>
    </message>
    <message>
        <source>{} needs {}, the depth that the measured part was cut at</source>
        <translation>{} потребує {}, глибини, з якою вирізано виміряну деталь</translation>
    </message>
    <message>
        <source>a first cut that leaves stock is made before anything is measured or predicted</source>
        <translation>перший прохід, що лишає припуск, роблять до вимірювання чи прогнозу</translation>
    </message>
    <message>
        <source>{} takes the whole error out: it goes with neither {} nor {}</source>
        <translation>{} знімає всю похибку: воно не поєднується ні з {}, ні з {}</translation>
    </message>
    <message>
        <source>{} is given {} times and measured parts {}: give it once, or once for each {}</source>
        <translation>{} вказано {} разів, виміряних деталей {}: вкажіть один раз або по разу на кожне {}</translation>
    </message>
    <message>
        <source>{} qif needs {}, the width of the profile's tolerance zone on the drawing</source>
        <translation>{} qif потребує {}, ширини поля допуску профілю на кресленні</translation>
    </message>
    <message>
        <source> or {}</source>
        <translation> або {}</translation>
    </message>
    <message>
        <source>{} belongs to {}, not to {}</source>
        <translation>{} належить до {}, а не до {}</translation>
    </message>
    <message>
        <source>{}: write the number or name and the diameter of a tool in mm, as {}</source>
        <translation>{}: напишіть номер чи назву й діаметр інструмента в мм, як {}</translation>
    </message>
    <message>
        <source>at {}: </source>
        <translation>у {}: </translation>
    </message>
    <message>
        <source>{}the commanded depth is {}, not above 0: a transfer function needs a cut; check {}</source>
        <translation>{}задана глибина {}, не більша за 0: передавальна функція потребує різання; перевірте {}</translation>
    </message>
    <message>
        <source>{}{} of a commanded depth of {} stayed: the transfer function delta/(H - delta) has no meaning there; check {}</source>
        <translation>{}{} із заданої глибини {} лишилося: передавальна функція delta/(H - delta) там не має сенсу; перевірте {}</translation>
    </message>
    <message>
        <source>the parts of different depth were measured at different places: nothing can be compared</source>
        <translation>деталі різної глибини виміряно в різних місцях: порівняти нічого</translation>
    </message>
    <message>
        <source>{}{:.0f} % of the difference between the depths stayed: no transfer function follows from that; check {}</source>
        <translation>{}{:.0f} % різниці глибин лишилося: передавальна функція з цього не випливає; перевірте {}</translation>
    </message>
    <message>
        <source>{}the normal is {:.0f} degrees off {}: a deviation along {} says little there; use {}</source>
        <translation>{}нормаль відхилена на {:.0f} градусів від {}: відхилення вздовж {} там мало що каже; використайте {}</translation>
    </message>
    <message>
        <source>check {} and which part was cut at which</source>
        <translation>перевірте {} і яку деталь з якою різали</translation>
    </message>
    <message>
        <source>the tool may be larger than stated or the path off; measure a part cut at another {} as well, or use {}</source>
        <translation>інструмент може бути більший, ніж сказано, або траєкторія збоку; виміряйте й деталь з іншою {}, або використайте {}</translation>
    </message>
    <message>
        <source>at {} the transfer function would be {:+.4f}, negative beyond its uncertainty of {:.4f}: no elastic system removes more than it is told to; {}</source>
        <translation>у {} передавальна функція була б {:+.4f}, від'ємна понад свою невизначеність {:.4f}: жодна пружна система не знімає більше заданого; {}</translation>
    </message>
    <message>
        <source>the transfer function would be {:.3f} in the middle: {:.0f} % of the depth would stay, which no machine is left to do; check {}</source>
        <translation>передавальна функція була б у середньому {:.3f}: лишилося б {:.0f} % глибини, чого верстат не робить; перевірте {}</translation>
    </message>
    <message>
        <source>the transfer function is {:.4f} in the middle: only {:.1f} % of the depth stays, less than milling machines give way; check {}</source>
        <translation>передавальна функція в середньому {:.4f}: лишається лише {:.1f} % глибини, менше, ніж піддаються фрезерні верстати; перевірте {}</translation>
    </message>
    <message>
        <source>the transfer function is {:.3f} at {}: {:.0f} % of the depth stays; check {}</source>
        <translation>передавальна функція {:.3f} у {}: лишається {:.0f} % глибини; перевірте {}</translation>
    </message>
    <message>
        <source>{} parts cut {} mm deep: the transfer function is taken from the difference, the constant offset apart; deviations are shown as at the depth of the first</source>
        <translation>{} деталі, вирізані на глибину {} мм: передавальна функція взята з різниці, сталий зсув окремо; відхилення показано як на глибині першої</translation>
    </message>
    <message>
        <source>{} stretches of contours without a measured point are left as they are</source>
        <translation>ділянок контурів без виміряної точки, що лишаються як є: {}</translation>
    </message>
    <message>
        <source>the parts were cut at different depths: say with {} what the next one takes off</source>
        <translation>деталі різали на різну глибину: скажіть через {}, скільки знімає наступний прохід</translation>
    </message>
    <message>
        <source>gain {:g} leaves {:.0f} % of what the next part would show on purpose</source>
        <translation>підсилення {:g} навмисно лишає {:.0f} % того, що показала б наступна деталь</translation>
    </message>
    <message>
        <source>one depth cannot tell a constant offset (tool radius, backlash, edge force) from elastic response: all of it is taken as elastic, which is right at the depth measured; for another depth measure two</source>
        <translation>одна глибина не відрізняє сталий зсув (радіус інструмента, люфт, сила на кромці) від піддатливості: усе вважається пружним, що правильно на виміряній глибині; для іншої виміряйте дві</translation>
    </message>
    <message>
        <source>deviations along {} with depths along the normal correct by {} more on average than {}</source>
        <translation>відхилення вздовж {} з глибинами вздовж нормалі коригують у середньому на {} більше, ніж {}</translation>
    </message>
    <message>
        <source>say {}: </source>
        <translation>вкажіть {}: </translation>
    </message>
    <message>
        <source> or </source>
        <translation> або </translation>
    </message>
    <message>
        <source>the profile has a cusp or a point where its parametrisation stands still</source>
        <translation>профіль має вістря або точку, де його параметризація стоїть на місці</translation>
    </message>
    <message>
        <source>the profile has no contour</source>
        <translation>профіль не має контуру</translation>
    </message>
    <message>
        <source>the profile has no length</source>
        <translation>профіль не має довжини</translation>
    </message>
    <message>
        <source>the profile has a cusp or a point where its parametrisation stands still near {}</source>
        <translation>профіль має вістря або точку, де його параметризація стоїть на місці, біля {}</translation>
    </message>
    <message>
        <source>contour {} of the profile has no length</source>
        <translation>контур {} профілю не має довжини</translation>
    </message>
    <message>
        <source>contour {} of the profile has a gap of {} at {}</source>
        <translation>контур {} профілю має розрив {} біля {}</translation>
    </message>
    <message>
        <source>profile: unit must be mm and material left</source>
        <translation>профіль: одиниця має бути мм, а матеріал — ліворуч</translation>
    </message>
    <message>
        <source>profile: {!r} is missing or of the wrong kind</source>
        <translation>профіль: {!r} бракує або воно хибного типу</translation>
    </message>
    <message>
        <source>not a millcorr profile: {}</source>
        <translation>не профіль millcorr: {}</translation>
    </message>
    <message>
        <source>{} needs a name: the measuring program is written there</source>
        <translation>{} потребує назви: туди буде записано вимірювальну програму</translation>
    </message>
    <message>
        <source>{}: say the radius at which the probe triggers</source>
        <translation>{}: вкажіть радіус спрацювання щупа</translation>
    </message>
    <message>
        <source>{} needs a name: the corrected program is written there</source>
        <translation>{} потребує назви: туди буде записано скориговану програму</translation>
    </message>
    <message>
        <source>name the program that finishes the part, and the one to write</source>
        <translation>назвіть програму, що завершує деталь, і ту, яку записати</translation>
    </message>
    <message>
        <source>name the setup and the directory for the report</source>
        <translation>назвіть налаштування і каталог для звіту</translation>
    </message>
    <message>
        <source>Share: the first cut takes more than 0 and less than 1 of the allowance</source>
        <translation>Частка: перший прохід бере понад 0 і менше за 1 припуску</translation>
    </message>
    <message>
        <source>Stock: say how much stands on the finished contour</source>
        <translation>Припуск: вкажіть, скільки лишається на готовому контурі</translation>
    </message>
    <message>
        <source>the angle does not give where this line ends</source>
        <translation>кут не показує, де закінчується цей кадр</translation>
    </message>
    <message>
        <source>the number of turns P of an arc is a whole number from 1</source>
        <translation>кількість обертів P дуги є цілим числом від 1</translation>
    </message>
    <message>
        <source>arc with a radius and a centre: keep one of them</source>
        <translation>дуга з радіусом і центром: залиште одне з них</translation>
    </message>
    <message>
        <source>arc without a centre: state I, J, K or R</source>
        <translation>дуга без центра: вкажіть I, J, K або R</translation>
    </message>
    <message>
        <source>arc with an absolute centre (G90.1) needs both of its coordinates</source>
        <translation>дуга з абсолютним центром (G90.1) потребує обох координат</translation>
    </message>
    <message>
        <source>arc whose end is not on its circle: correct it</source>
        <translation>дуга, кінець якої не лежить на її колі: виправте її</translation>
    </message>
    <message>
        <source>arc of radius zero: state its centre</source>
        <translation>дуга з нульовим радіусом: вкажіть її центр</translation>
    </message>
    <message>
        <source>arc radius shorter than half the way to its end: correct R</source>
        <translation>радіус дуги менший за половину шляху до її кінця: виправте R</translation>
    </message>
    <message>
        <source>arc with R ends where it starts: state I, J for a circle</source>
        <translation>дуга з R кінчається там, де починається: для кола вкажіть I, J</translation>
    </message>
    <message>
        <source>G92 shifts the frame</source>
        <translation>G92 зміщує систему координат</translation>
    </message>
    <message>
        <source>G92.3 shifts the frame</source>
        <translation>G92.3 зсуває систему координат</translation>
    </message>
    <message>
        <source>G52 turns the frame</source>
        <translation>G52 змінює систему координат</translation>
    </message>
    <message>
        <source>G10 may change a work offset</source>
        <translation>G10 може змінити зсув нуля</translation>
    </message>
    <message>
        <source>G11 shifts or turns the frame</source>
        <translation>G11 зсуває або повертає систему координат</translation>
    </message>
    <message>
        <source>G68 rotates the frame</source>
        <translation>G68 повертає систему координат</translation>
    </message>
    <message>
        <source>G68.1 rotates the frame</source>
        <translation>G68.1 повертає систему координат</translation>
    </message>
    <message>
        <source>G68.2 tilts the plane</source>
        <translation>G68.2 нахиляє площину</translation>
    </message>
    <message>
        <source>G68.3 tilts the plane</source>
        <translation>G68.3 нахиляє площину</translation>
    </message>
    <message>
        <source>G68.4 tilts the plane</source>
        <translation>G68.4 нахиляє площину</translation>
    </message>
    <message>
        <source>G68.5 turns the frame</source>
        <translation>G68.5 повертає систему координат</translation>
    </message>
    <message>
        <source>G92.5 turns the frame</source>
        <translation>G92.5 повертає систему координат</translation>
    </message>
    <message>
        <source>G254 lets the work offset turn with the part</source>
        <translation>G254 дає зміщенню нуля повертатися разом із деталлю</translation>
    </message>
    <message>
        <source>G51 scales the frame</source>
        <translation>G51 масштабує систему координат</translation>
    </message>
    <message>
        <source>G51.1 mirrors the frame</source>
        <translation>G51.1 віддзеркалює систему координат</translation>
    </message>
    <message>
        <source>G101 mirrors the frame</source>
        <translation>G101 віддзеркалює систему координат</translation>
    </message>
    <message>
        <source>G16 states polar coordinates</source>
        <translation>G16 задає полярні координати</translation>
    </message>
    <message>
        <source>G12.1 interpolates in polar coordinates</source>
        <translation>G12.1 інтерполює в полярних координатах</translation>
    </message>
    <message>
        <source>G112 interpolates in polar coordinates</source>
        <translation>G112 інтерполює в полярних координатах</translation>
    </message>
    <message>
        <source>G7.1 interpolates on a cylinder</source>
        <translation>G7.1 інтерполює на циліндрі</translation>
    </message>
    <message>
        <source>G107 interpolates on a cylinder</source>
        <translation>G107 інтерполює на циліндрі</translation>
    </message>
    <message>
        <source>G7 states diameters</source>
        <translation>G7 задає діаметри</translation>
    </message>
    <message>
        <source>G43.4 controls the tool centre point</source>
        <translation>G43.4 керує центром інструмента (TCP)</translation>
    </message>
    <message>
        <source>G43.5 controls the tool centre point</source>
        <translation>G43.5 керує центром інструмента (TCP)</translation>
    </message>
    <message>
        <source>G234 controls the tool centre point</source>
        <translation>G234 керує центром інструмента (TCP)</translation>
    </message>
    <message>
        <source>G66 calls a macro at every move</source>
        <translation>G66 викликає макрос за кожного руху</translation>
    </message>
    <message>
        <source>G93 states the feed as inverse time</source>
        <translation>G93 задає подачу як обернений час</translation>
    </message>
    <message>
        <source>ROT, MIRROR or SCALE changes the frame</source>
        <translation>ROT, MIRROR або SCALE змінює систему координат</translation>
    </message>
    <message>
        <source>CYCLE800 swivels the frame</source>
        <translation>CYCLE800 повертає систему координат</translation>
    </message>
    <message>
        <source>MCALL calls a cycle behind every move</source>
        <translation>MCALL викликає цикл після кожного переміщення</translation>
    </message>
    <message>
        <source>G65 calls a macro</source>
        <translation>G65 викликає макрос</translation>
    </message>
    <message>
        <source>this line becomes several moves, but its M code belongs behind the last of them</source>
        <translation>цей кадр стає кількома рухами, а його M-код належить за останнім із них</translation>
    </message>
    <message>
        <source>{}: put the M code on a line of its own</source>
        <translation>{}: напишіть M-код окремим кадром</translation>
    </message>
    <message>
        <source>{}{}{} cannot be corrected: {}</source>
        <translation>{}{}{} скоригувати не можна: {}</translation>
    </message>
    <message>
        <source>rounding would make another arc of this one: allow more decimals</source>
        <translation>після округлення дуга стала б іншою: дозвольте більше знаків після коми</translation>
    </message>
    <message>
        <source>toolpath: an arc of line {} is not in the plane in force there</source>
        <translation>траєкторія: дуга рядка {} не лежить у площині, чинній там</translation>
    </message>
    <message>
        <source>the turns of this arc would change: write it as arcs of one turn</source>
        <translation>оберти цієї дуги змінилися б: запишіть її дугами в один оберт</translation>
    </message>
    <message>
        <source>toolpath: a move of line {} of {} starts {} from where the one before ends</source>
        <translation>траєкторія: рух рядка {} з {} починається за {} від кінця попереднього</translation>
    </message>
    <message>
        <source>controls round numbers below zero differently</source>
        <translation>системи ЧПК по-різному округлюють числа, менші за нуль</translation>
    </message>
    <message>
        <source>'{}' has no value</source>
        <translation>«{}» не має значення</translation>
    </message>
    <message>
        <source>controls divide numbers below zero differently</source>
        <translation>системи ЧПК по-різному ділять числа, менші за нуль</translation>
    </message>
    <message>
        <source>{} of bits is not computed</source>
        <translation>{} над бітами не обчислюється</translation>
    </message>
    <message>
        <source>an expression is not complete</source>
        <translation>вираз неповний</translation>
    </message>
    <message>
        <source>a bracket is missing</source>
        <translation>бракує дужки</translation>
    </message>
    <message>
        <source>a bracket is not closed</source>
        <translation>дужку не закрито</translation>
    </message>
    <message>
        <source>{} has no value that this program sets</source>
        <translation>{} не має значення, яке задає ця програма</translation>
    </message>
    <message>
        <source>controls give arc tangents below zero differently</source>
        <translation>системи ЧПК по-різному дають арктангенс, менший за нуль</translation>
    </message>
    <message>
        <source>'{}' is no value</source>
        <translation>«{}» не є значенням</translation>
    </message>
    <message>
        <source>ATAN of one number is not computed</source>
        <translation>ATAN одного числа не обчислюється</translation>
    </message>
    <message>
        <source>a variable</source>
        <translation>змінна</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>файл порожній</translation>
    </message>
    <message>
        <source>this is a binary file or UTF-16 text: save the program as plain text</source>
        <translation>це двійковий файл або текст в UTF-16: збережіть програму як простий текст</translation>
    </message>
    <message>
        <source>cannot read '{}': is this a plain-language block?</source>
        <translation>не вдається прочитати «{}»: чи це кадр Klartext?</translation>
    </message>
    <message>
        <source>BEGIN PGM without a unit: state MM or INCH</source>
        <translation>BEGIN PGM без одиниці: вкажіть MM або INCH</translation>
    </message>
    <message>
        <source>this line runs {} times, and its {} and {} want other words: write the runs out, each with lines of its own</source>
        <translation>цей рядок виконується {} разів, і його {} та {} потребують різних слів: випишіть проходи, кожен своїми рядками</translation>
    </message>
    <message>
        <source>{}{} cannot be corrected: {} is used {} times (line {}); state the numbers in these lines</source>
        <translation>{}{} не можна скоригувати: {} використано {} разів (рядок {}); вкажіть числа в цих рядках</translation>
    </message>
    <message>
        <source>'{}' would not be read: {}</source>
        <translation>«{}» не було б прочитано: {}</translation>
    </message>
    <message>
        <source>toolpath: line {} of {} cannot be written</source>
        <translation>траєкторія: рядок {} з {} не можна записати</translation>
    </message>
    <message>
        <source>arc from an unknown start: state the position before it</source>
        <translation>дуга з невідомого початку: вкажіть перед нею положення</translation>
    </message>
    <message>
        <source>G5.1 with a target is not followed</source>
        <translation>G5.1 із ціллю не відстежується</translation>
    </message>
    <message>
        <source>arc from an unknown start</source>
        <translation>дуга з невідомого початку</translation>
    </message>
    <message>
        <source>arc with a pitch word along its axis</source>
        <translation>дуга з кроком уздовж її осі</translation>
    </message>
    <message>
        <source>G5 works in the XY plane only: state G17</source>
        <translation>G5 діє лише в площині XY: вкажіть G17</translation>
    </message>
    <message>
        <source>G5 needs both I and J, or neither behind another G5</source>
        <translation>G5 потребує I і J, або жодного після іншого G5</translation>
    </message>
    <message>
        <source>G5 needs P and Q</source>
        <translation>G5 потребує P і Q</translation>
    </message>
    <message>
        <source>G5 moves X and Y only: move Z on a line of its own</source>
        <translation>G5 рухає лише X і Y: перемістіть Z окремим кадром</translation>
    </message>
    <message>
        <source>the first G5 of a row needs I and J</source>
        <translation>перше G5 у ряді потребує I і J</translation>
    </message>
    <message>
        <source>spline from an unknown start: state the position before it</source>
        <translation>сплайн із невідомого початку: вкажіть перед ним положення</translation>
    </message>
    <message>
        <source>G{:g} is not a G code</source>
        <translation>G{:g} не є G-кодом</translation>
    </message>
    <message>
        <source>two {} words on one line: keep the one that is meant</source>
        <translation>два слова {} в одному кадрі: залиште потрібне</translation>
    </message>
    <message>
        <source>G{:g} and G{:g} on one line contradict each other</source>
        <translation>G{:g} і G{:g} в одному кадрі суперечать одне одному</translation>
    </message>
    <message>
        <source>G{:g} is not followed</source>
        <translation>G{:g} не відстежується</translation>
    </message>
    <message>
        <source>a rotary or parallel axis moves with this line</source>
        <translation>у цьому кадрі рухається поворотна або паралельна вісь</translation>
    </message>
    <message>
        <source>no motion code is in force</source>
        <translation>жоден код руху не діє</translation>
    </message>
    <message>
        <source>axis words behind G80</source>
        <translation>слова осей після G80</translation>
    </message>
    <message>
        <source>canned cycle, never rewritten</source>
        <translation>постійний цикл, ніколи не переписується</translation>
    </message>
    <message>
        <source>G28 or G30 leaves the work frame</source>
        <translation>G28 або G30 виходить із системи деталі</translation>
    </message>
    <message>
        <source>G53 moves in the machine frame</source>
        <translation>G53 рухає в системі верстата</translation>
    </message>
    <message>
        <source>a corner rounding or chamfer that is not followed</source>
        <translation>заокруглення кута або фаска, що не відстежується</translation>
    </message>
    <message>
        <source>{}, G90 or G91 is not stated afresh behind it</source>
        <translation>{}, G90 чи G91 після цього не вказано наново</translation>
    </message>
    <message>
        <source>two corner words on one line</source>
        <translation>два слова кута в одному рядку</translation>
    </message>
    <message>
        <source>the feed of the corner is not known</source>
        <translation>подача на куті невідома</translation>
    </message>
    <message>
        <source>this way to state an arc is not followed</source>
        <translation>такий спосіб задати дугу не відстежується</translation>
    </message>
    <message>
        <source>behind the end of the program</source>
        <translation>після кінця програми</translation>
    </message>
    <message>
        <source>a corner word without a move</source>
        <translation>слово кута без руху</translation>
    </message>
    <message>
        <source>the control's settings decide which of two feeds holds in the corner</source>
        <translation>налаштування верстата з ЧПК вирішують, яка з двох подач діє на куті</translation>
    </message>
    <message>
        <source>{} SUB without its ENDSUB</source>
        <translation>{} SUB без свого ENDSUB</translation>
    </message>
    <message>
        <source>no line N{:g} is there to go to</source>
        <translation>немає кадру N{:g}, до якого перейти</translation>
    </message>
    <message>
        <source>a subprogram is called</source>
        <translation>викликається підпрограма</translation>
    </message>
    <message>
        <source>subprogram {} is called, which is neither in the file nor beside it</source>
        <translation>викликається підпрограма {}, якої немає ні у файлі, ні поруч</translation>
    </message>
    <message>
        <source>subprograms call each other without end</source>
        <translation>підпрограми викликають одна одну без кінця</translation>
    </message>
    <message>
        <source>M99 with L is not followed</source>
        <translation>M99 з L не відстежується</translation>
    </message>
    <message>
        <source>'{}' is not followed</source>
        <translation>«{}» не відстежується</translation>
    </message>
    <message>
        <source>no label {} is there to go to</source>
        <translation>немає мітки {}, до якої перейти</translation>
    </message>
    <message>
        <source>a loop or choice is not complete</source>
        <translation>цикл або розгалуження неповні</translation>
    </message>
    <message>
        <source>subprogram {} is called, which is not in the file</source>
        <translation>викликається підпрограма {}, якої немає у файлі</translation>
    </message>
    <message>
        <source>{}: which line comes next is not known</source>
        <translation>{}: невідомо, який кадр наступний</translation>
    </message>
    <message>
        <source>REPEAT of what stands behind it is not followed</source>
        <translation>REPEAT того, що стоїть далі, не відстежується</translation>
    </message>
    <message>
        <source>REPEAT of lines that call or jump is not followed</source>
        <translation>REPEAT кадрів із викликами чи переходами не відстежується</translation>
    </message>
    <message>
        <source>a loop does not end</source>
        <translation>цикл не закінчується</translation>
    </message>
    <message>
        <source>{} is computed by a macro expression: {}</source>
        <translation>{} обчислює макровираз: {}</translation>
    </message>
    <message>
        <source>where this polar position is, is not known</source>
        <translation>де лежить ця полярна позиція, невідомо</translation>
    </message>
    <message>
        <source>a polar position of this motion code is not followed</source>
        <translation>полярна позиція з цим кодом руху не відстежується</translation>
    </message>
    <message>
        <source>plain G0 to G3 moves</source>
        <translation>прості рухи G0–G3</translation>
    </message>
    <message>
        <source> since line {}</source>
        <translation> від рядка {}</translation>
    </message>
    <message>
        <source>this move cannot be corrected: {}{}; write the stretch as {}</source>
        <translation>цей рух скоригувати не можна: {}{}; запишіть цю ділянку як {}</translation>
    </message>
    <message>
        <source>toolpath: its lines are not those of the program, in their order</source>
        <translation>траєкторія: її рядки не є рядками програми в їхньому порядку</translation>
    </message>
    <message>
        <source>this move cannot be corrected: it stands in a file beside the program; put the subprogram into the program's own file</source>
        <translation>цей рух скоригувати не можна: він стоїть у файлі поруч із програмою; перенесіть підпрограму у файл програми</translation>
    </message>
    <message>
        <source>this line runs {} times, and its {} and {} want {}: write the runs out, each with lines of its own</source>
        <translation>цей кадр виконується {} разів, а {} і {} потребують: {}; розпишіть проходи, кожен своїми кадрами</translation>
    </message>
    <message>
        <source>run {}</source>
        <translation>прохід {}</translation>
    </message>
    <message>
        <source> at Z{:g}</source>
        <translation> на Z{:g}</translation>
    </message>
    <message>
        <source>other words</source>
        <translation>інших слів</translation>
    </message>
    <message>
        <source>other moves</source>
        <translation>інших рухів</translation>
    </message>
    <message>
        <source>corrections that differ by {}</source>
        <translation>корекцій, що різняться на {}</translation>
    </message>
    <message>
        <source>cannot read '{}': is this an NC program?</source>
        <translation>не вдається прочитати «{}»: чи це програма ЧПК?</translation>
    </message>
    <message>
        <source>'{}' calls a label as HEIDENHAIN's ISO programs do: let the program begin with %NAME G71 or G70</source>
        <translation>«{}» викликає мітку, як програми ISO HEIDENHAIN: програма має починатися з %NAME G71 або G70</translation>
    </message>
    <message>
        <source>decimal comma in '{}': write numbers with a decimal point</source>
        <translation>десяткова кома в «{}»: пишіть числа з десятковою крапкою</translation>
    </message>
    <message>
        <source>comment without ')': close it on the same line</source>
        <translation>коментар без «)»: закрийте його в тому самому рядку</translation>
    </message>
    <message>
        <source>'{}' is not a word: a letter needs one number behind it</source>
        <translation>«{}» не є словом: за літерою має стояти одне число</translation>
    </message>
    <message>
        <source>{} is not plain ISO code</source>
        <translation>{} не є простим кодом ISO</translation>
    </message>
    <message>
        <source>number too large: correct it</source>
        <translation>число завелике: виправте його</translation>
    </message>
    <message>
        <source>an O word steers the program</source>
        <translation>слово O керує програмою</translation>
    </message>
    <message>
        <source>{} may change the frame</source>
        <translation>{} може змінити систему координат</translation>
    </message>
    <message>
        <source>{} is not followed</source>
        <translation>{} не відстежується</translation>
    </message>
    <message>
        <source>OFFN shifts the contour</source>
        <translation>OFFN зміщує контур</translation>
    </message>
    <message>
        <source>{}={}() is not followed</source>
        <translation>{}={}() не відстежується</translation>
    </message>
    <message>
        <source>{} is computed by a macro expression</source>
        <translation>{} обчислює макровираз</translation>
    </message>
    <message>
        <source>a plain-language block among ISO code; write the program in one of both languages</source>
        <translation>кадр мовою Klartext серед кадрів ISO; пишіть програму однією з двох мов</translation>
    </message>
    <message>
        <source>the program returns</source>
        <translation>програма повертається</translation>
    </message>
    <message>
        <source>variable set: {}</source>
        <translation>задано змінну: {}</translation>
    </message>
    <message>
        <source>{} is assigned with '='</source>
        <translation>{} присвоєно через «=»</translation>
    </message>
    <message>
        <source>which variable it is, is computed; state the number here</source>
        <translation>яка це змінна, обчислюється; вкажіть тут число</translation>
    </message>
    <message>
        <source>{} is used {} times (line {}); state the numbers in these lines</source>
        <translation>{} вжито {} разів (рядок {}); вкажіть у цих рядках числа</translation>
    </message>
    <message>
        <source>{}, set in line {},</source>
        <translation>{}, задана в рядку {},</translation>
    </message>
    <message>
        <source>the numbers of this program cannot be read; is it an NC program?</source>
        <translation>числа цієї програми не вдається прочитати; чи це програма ЧПК?</translation>
    </message>
    <message>
        <source>the motion code before this line has changed: state it here</source>
        <translation>код руху перед цим кадром змінився: вкажіть його тут</translation>
    </message>
    <message>
        <source>the feed before this line has changed: state it here</source>
        <translation>подача перед цим рядком змінилася: укажіть її тут</translation>
    </message>
    <message>
        <source>the position before this line has changed, but not its move: {}</source>
        <translation>положення перед цим кадром змінилося, а його рух ні: {}</translation>
    </message>
    <message>
        <source>lead the cut out to a stated {} on a line before it</source>
        <translation>виведіть різання попереднім кадром на вказане {}</translation>
    </message>
    <message>
        <source>state {} here</source>
        <translation>вкажіть тут {}</translation>
    </message>
    <message>
        <source>must be {}{}</source>
        <translation>має бути {}{}</translation>
    </message>
    <message>
        <source>must be from {:g} to {:g}</source>
        <translation>має бути від {:g} до {:g}</translation>
    </message>
    <message>
        <source>above {:g}</source>
        <translation>понад {:g}</translation>
    </message>
    <message>
        <source>at least {:g}</source>
        <translation>щонайменше {:g}</translation>
    </message>
    <message>
        <source> and at most {:g}</source>
        <translation> і щонайбільше {:g}</translation>
    </message>
    <message>
        <source>{}: choose one of {}</source>
        <translation>{}: виберіть одне з {}</translation>
    </message>
    <message>
        <source>the corrected path near {} cannot be written within {}</source>
        <translation>скориговану траєкторію біля {} не записати в межах {}</translation>
    </message>
    <message>
        <source>near {} the program runs {} off the profile at {} and {} off it at {}: which pass carries the correction cannot be told; correct the first, uncorrected program, or one that holds the finishing pass alone</source>
        <translation>біля {} програма йде на {} від профілю на {} і на {} від нього на {}: який прохід несе корекцію, сказати не можна; коригуйте першу, некориговану програму або ту, що має лише чистовий прохід</translation>
    </message>
    <message>
        <source>the written program reads back with {} moves in place of {}</source>
        <translation>записана програма читається з {} рухами замість {}</translation>
    </message>
    <message>
        <source>{} stays at {}: what is wanted there is too narrow for a cutter of {}; a smaller one would reach it</source>
        <translation>{} лишається у {}: те, що там потрібне, завузьке для фрези {}; менша дістала б</translation>
    </message>
    <message>
        <source>line {} of the corrected program, which is not corrected itself, cuts {} into the corrected surface at {}, beyond what was measured: if that is a wall of the part and no lead, {} moves such passes along</source>
        <translation>рядок {} скоригованої програми, сам не скоригований, врізається на {} у скориговану поверхню у {}, за межами виміряного: якщо це стінка деталі, а не підхід, {} зсуває такі проходи разом</translation>
    </message>
    <message>
        <source>other passes on the corrected wall are moved along with it: lines {} of {}</source>
        <translation>інші проходи по скоригованій стінці зсунуто разом: рядки {} з {}</translation>
    </message>
    <message>
        <source>line {} of the written program goes to {} and not where it was planned to go</source>
        <translation>рядок {} записаної програми йде в {}, а не куди заплановано</translation>
    </message>
    <message>
        <source>the written program differs where it must not: its block numbers do not follow one another</source>
        <translation>записана програма відрізняється там, де не повинна: номери її кадрів не йдуть один за одним</translation>
    </message>
    <message>
        <source>line {} of the corrected program would cut {} into another wall at {}, which line {} of the program has made and which is not corrected: measure it, too, or correct less there</source>
        <translation>рядок {} скоригованої програми врізався б на {} в іншу стінку біля {}, яку зробив рядок {} програми і яку не скориговано: виміряйте і її або коригуйте там менше</translation>
    </message>
    <message>
        <source>the program does not cut the profile near {}, where points were measured: give the {} that cuts it, or only the points that belong to it</source>
        <translation>програма не ріже профіль біля {}, де виміряно точки: дайте {}, що його ріже, або лише точки, що до неї належать</translation>
    </message>
    <message>
        <source>no move of the program follows the profile at {}: the nearest runs {} off; check {}, {}, stock to leave and the work frame</source>
        <translation>жоден рух програми не йде за профілем на відстані {}: найближчий на {} убік; перевірте {}, {}, припуск і систему деталі</translation>
    </message>
    <message>
        <source>the compensated profile near {} cannot be fitted better than {}: the deviations change too fast; use a stronger {}</source>
        <translation>скоригований профіль біля {} не вдається наблизити краще ніж до {}: відхилення міняються зашвидко; потрібен сильніший {}</translation>
    </message>
    <message>
        <source>the correction leaves nothing of the {} long piece of the profile near {}</source>
        <translation>корекція нічого не лишає від {} ділянки профілю біля {}</translation>
    </message>
    <message>
        <source>the corrected contour does not close at the corner {}</source>
        <translation>скоригований контур не замикається в куті {}</translation>
    </message>
    <message>
        <source>the written program leaves no surface near {} that could be proven</source>
        <translation>записана програма не лишає біля {} поверхні, яку можна довести</translation>
    </message>
    <message>
        <source>line {} of the corrected program, which is not corrected itself, would cut {} into the corrected surface at {}: it leaves too little stock for it; {} moves such passes along</source>
        <translation>рядок {} скоригованої програми, сам не скоригований, врізався б на {} у скориговану поверхню у {}: він лишає замало припуску; {} зсуває такі проходи разом</translation>
    </message>
    <message>
        <source>the written program differs where it must not: line {}: {}</source>
        <translation>записана програма відрізняється там, де не повинна: рядок {}: {}</translation>
    </message>
    <message>
        <source>the written program differs where it must not: line {}: its header is another one</source>
        <translation>записана програма відрізняється там, де не повинна: рядок {}: її заголовок інший</translation>
    </message>
    <message>
        <source>the corrected {} would be {} off at {}, more than the tolerance of {}</source>
        <translation>скориговане ({}) було б на {} убік у {}, більше за допуск {}</translation>
    </message>
    <message>
        <source>path</source>
        <translation>траєкторія</translation>
    </message>
    <message>
        <source>surface</source>
        <translation>поверхня</translation>
    </message>
    <message>
        <source>{} (the cutter gouges there)</source>
        <translation>{} (фреза там зарізає)</translation>
    </message>
    <message>
        <source>{}: where that does no harm, a larger {}</source>
        <translation>{}: де це не шкодить, більше {}</translation>
    </message>
    <message>
        <source>the posted program lacks the move to {} (command {} of the path)</source>
        <translation>у виведеній програмі бракує руху до {} (команда {} траєкторії)</translation>
    </message>
    <message>
        <source>an outlier: more probably wrong than right, by its neighbours</source>
        <translation>викид: судячи із сусідніх точок, радше хибна, ніж правильна</translation>
    </message>
    <message>
        <source>gain {:g} leaves {:.0f} % of the determined deviation on purpose</source>
        <translation>підсилення {:g} навмисно лишає {:.0f} % визначеного відхилення</translation>
    </message>
    <message>
        <source>{} of {} points cannot be used, most are {}: see the report for which</source>
        <translation>{} з {} точок не придатні, більшість: {}; які саме, див. у звіті</translation>
    </message>
    <message>
        <source>a tool's diameter {} for {}</source>
        <translation>діаметр інструмента {} замість {}</translation>
    </message>
    <message>
        <source>mean {} all along, form only {}: check for {}; else the machine gives way</source>
        <translation>середнє {} всюди, форма лише {}: перевірте, чи це {}; інакше піддається верстат</translation>
    </message>
    <message>
        <source>sides that lie {} off the other {} all along (each within {}): {}, the first at {}; compare that dimension with the drawing: another revision, or a wall that gives way</source>
        <translation>сторони, що всюди на {} від інших {} (кожна в межах {}): {}, перша у {}; порівняйте цей розмір із кресленням: інша редакція або піддатлива стінка</translation>
    </message>
    <message>
        <source>only {} of {} points can be used, most others are {}: is the program whole, and is it the one that cut the part?</source>
        <translation>лише {} з {} точок придатні, більшість інших: {}; чи програма ціла і чи саме вона різала деталь?</translation>
    </message>
    <message>
        <source>check the height of the work frame of the measurement</source>
        <translation>перевірте висоту системи деталі у вимірюванні</translation>
    </message>
    <message>
        <source>{} of {} points on the profile ({} to {}) lie {} all that the program cuts, {}: {}, or leave the column z out</source>
        <translation>{} з {} точок на профілі ({} до {}) лежать {} всього, що ріже програма, {}: {}, або не беріть стовпець z</translation>
    </message>
    <message>
        <source>{} points (from {}) lie below the deepest pass at {}: {}</source>
        <translation>{} точок (від {}) лежать нижче найглибшого проходу на {}: {}</translation>
    </message>
    <message>
        <source>{} points (up to {}) lie above {}, from where the cutter comes down: {}</source>
        <translation>{} точок (до {}) лежать вище {}, звідки опускається фреза: {}</translation>
    </message>
    <message>
        <source>a probe's radius {} for {}</source>
        <translation>радіус щупа {} замість {}</translation>
    </message>
    <message>
        <source>steel measured {:.0f} K too warm</source>
        <translation>сталь виміряно на {:.0f} K теплішою</translation>
    </message>
    <message>
        <source>{:.0f} % of the deviations are what a shift of X{} Y{} and a turn of {:+.0f} arc seconds would give: check the alignment of the measurement ({}), or correct the work offset</source>
        <translation>{:.0f} % відхилень такі, які дав би зсув X{} Y{} і поворот на {:+.0f} кутових секунд: перевірте вирівнювання вимірювання ({}) або виправте зсув нуля</translation>
    </message>
    <message>
        <source>{:.0f} % of the deviations are what a size of {:.6f} times the profile's would give ({} at the rim; steel grows by 11.5 millionths a degree): check temperature, unit and scale of the measurement; no scale is ever applied</source>
        <translation>{:.0f} % відхилень такі, які дав би розмір у {:.6f} раза від профілю ({} на краю; сталь росте на 11,5 мільйонних на градус): перевірте температуру, одиницю й масштаб вимірювання; масштаб ніколи не застосовується</translation>
    </message>
    <message>
        <source>{} to {}</source>
        <translation>{} до {}</translation>
    </message>
    <message>
        <source>{} up</source>
        <translation>{} і вище</translation>
    </message>
    <message>
        <source>below</source>
        <translation>нижче</translation>
    </message>
    <message>
        <source>above</source>
        <translation>вище</translation>
    </message>
    <message>
        <source>a probe's radius {} too small</source>
        <translation>радіус щупа на {} замалий</translation>
    </message>
    <message>
        <source>a probe's radius {} too large</source>
        <translation>радіус щупа на {} завеликий</translation>
    </message>
    <message>
        <source>{} of stock left</source>
        <translation>{} лишеного припуску</translation>
    </message>
    <message>
        <source>times 25.4</source>
        <translation>помножені на 25,4</translation>
    </message>
    <message>
        <source>divided by 25.4</source>
        <translation>поділені на 25,4</translation>
    </message>
    <message>
        <source>with z reversed</source>
        <translation>з оберненим z</translation>
    </message>
    <message>
        <source>{} they would lie there; check the unit of z and the height of the work frame</source>
        <translation>{} вони лежали б там; перевірте одиницю z і висоту системи деталі</translation>
    </message>
    <message>
        <source>steel measured {:.0f} K too cold</source>
        <translation>сталь виміряно на {:.0f} K холоднішою</translation>
    </message>
    <message>
        <source>{}: the nominal was probably exported in place of the measured points; export the actual points, to 0.0001 mm</source>
        <translation>{}: мабуть, замість виміряних точок виведено номінал; виведіть фактичні точки, до 0,0001 мм</translation>
    </message>
    <message>
        <source>{} states a deviation of {}, its points give {} ({} of {} disagree): {}; leave the column of deviations out, or correct it</source>
        <translation>{} подає відхилення {}, а його точки дають {} ({} з {} не збігаються): {}; не беріть стовпець відхилень або виправте його</translation>
    </message>
    <message>
        <source>the {} points are a height map, touched along Z: they show nothing of a contour; touch its walls with a measuring program</source>
        <translation>{} точок є картою висот, дотики вздовж Z: вони нічого не показують про контур; торкніться його стінок вимірювальною програмою</translation>
    </message>
    <message>
        <source>a ball of radius {} is on no touch probe ({} to {})</source>
        <translation>кульки радіуса {} немає на жодному щупі ({} до {})</translation>
    </message>
    <message>
        <source>the points extend over {}, and the file does not say its unit: {}? Say {} if it is right, {}, or export in mm</source>
        <translation>точки простягаються на {}, а файл не називає одиниці: {}? Скажіть {}, якщо так і є, {}, або виведіть у мм</translation>
    </message>
    <message>
        <source>the coordinates are given in steps of {}, which alone scatters deviations by {} (standard deviation): export to 0.0001 mm</source>
        <translation>координати подано з кроком {}, що саме розкидає відхилення на {} (стандартне відхилення): виведіть до 0,0001 мм</translation>
    </message>
    <message>
        <source>every deviation is 0</source>
        <translation>кожне відхилення дорівнює 0</translation>
    </message>
    <message>
        <source>no deviation is larger than {}, what rounding to {} alone makes</source>
        <translation>жодне відхилення не більше за {}, що дає саме округлення до {}</translation>
    </message>
    <message>
        <source>its sign is the other way round, positive into the material</source>
        <translation>його знак обернений, додатний углиб матеріалу</translation>
    </message>
    <message>
        <source>check what its columns mean</source>
        <translation>перевірте, що означають його стовпці</translation>
    </message>
    <message>
        <source>{}; {:.4g} inch are {}, and the file does not say its unit: {}</source>
        <translation>{}; {:.4g} дюйма це {}, а файл не називає одиниці: {}</translation>
    </message>
    <message>
        <source>{}: {} takes a radius in mm</source>
        <translation>{}: {} є радіусом у мм</translation>
    </message>
    <message>
        <source>metres or inches</source>
        <translation>метри чи дюйми</translation>
    </message>
    <message>
        <source>micrometres</source>
        <translation>мікрометри</translation>
    </message>
    <message>
        <source>{}: there is no such finding; known are {}</source>
        <translation>{}: такої знахідки немає; відомі {}</translation>
    </message>
    <message>
        <source>accepted {}: {}</source>
        <translation>прийнято {}: {}</translation>
    </message>
    <message>
        <source>the part shows {:.0f} % of just the errors (up to {}) that the program takes away already, {:.0f} % of its deviations: was it cut with this program, and not with the earlier one? Measure a part cut with this program, or give the program that cut this one</source>
        <translation>деталь показує {:.0f} % саме тих похибок (до {}), які програма вже знімає, {:.0f} % її відхилень: чи різано її цією програмою, а не попередньою? Виміряйте деталь, вирізану цією програмою, або дайте програму, що різала цю</translation>
    </message>
    <message>
        <source>{:.0f} % of the points of {} lie where {} has none, and only places of the first part tell the transfer function: name first the part that was measured all round ({})</source>
        <translation>{:.0f} % точок {} лежать там, де {} їх не має, а передавальну функцію дають лише місця першої деталі: назвіть першою деталь, виміряну довкола ({})</translation>
    </message>
    <message>
        <source>{:.0f} % of the points of {} lie within {} of those of {}: the same part again, and no mean of two; give each part once</source>
        <translation>{:.0f} % точок {} лежать у межах {} від точок {}: знову та сама деталь, а не середнє двох; дайте кожну деталь один раз</translation>
    </message>
    <message>
        <source>the file's own nominal points lie {} off the profile: check {}, the operation and the work frame</source>
        <translation>власні номінальні точки файлу лежать на {} від профілю: перевірте {}, операцію і систему деталі</translation>
    </message>
    <message>
        <source>the normals of {} of {} points point into the material: export normals out of the material, not directions of approach</source>
        <translation>нормалі {} з {} точок дивляться в матеріал: виведіть нормалі з матеріалу назовні, а не напрями підходу</translation>
    </message>
    <message>
        <source>points on thin walls that lie so far off that the other side may be meant: {}, the thinnest wall {} ({}, {}); the file has no normals: export normals</source>
        <translation>точки на тонких стінках, що лежать так далеко, що може йтися про інший бік: {}, найтонша стінка {} ({}, {}); файл не має нормалей: виведіть нормалі</translation>
    </message>
    <message>
        <source>mirror the work frame of the measurement</source>
        <translation>віддзеркальте систему деталі у вимірюванні</translation>
    </message>
    <message>
        <source>turn the work frame of the measurement back</source>
        <translation>поверніть систему деталі у вимірюванні назад</translation>
    </message>
    <message>
        <source>the points lie {} off {} all along, with only {} of scatter</source>
        <translation>точки всюди лежать на {} від {}, з розкидом лише {}</translation>
    </message>
    <message>
        <source>the surface {} over the profile</source>
        <translation>поверхні на {} над профілем</translation>
    </message>
    <message>
        <source>the profile</source>
        <translation>профілю</translation>
    </message>
    <message>
        <source>{}: {} seems to be the diameter: {}</source>
        <translation>{}: {} схоже на діаметр: {}</translation>
    </message>
    <message>
        <source>{}: {} seems to be half of what it should be: {}</source>
        <translation>{}: {} схоже на половину потрібного: {}</translation>
    </message>
    <message>
        <source>{}, the cutter's diameter: the profile was taken on the wrong side of the path: {}</source>
        <translation>{}, діаметр фрези: профіль узято з хибного боку траєкторії: {}</translation>
    </message>
    <message>
        <source>{}: what a transfer function of {:.3f} leaves of {}</source>
        <translation>{}: те, що передавальна функція {:.3f} лишає від {}</translation>
    </message>
    <message>
        <source>{}: check {}, by this {} were left, and {} and {}</source>
        <translation>{}: перевірте {}, за ним лишилося б {}, і {} та {}</translation>
    </message>
    <message>
        <source>{}: they look like centres of a ball of about that radius: {} with the radius from the probe's calibration; or stock was left there ({}), or the tool differs from {}</source>
        <translation>{}: вони схожі на центри кульки приблизно такого радіуса: {} з радіусом із калібрування щупа; або там лишено припуск ({}), або інструмент відрізняється від {}</translation>
    </message>
    <message>
        <source>{}: check {}, {} (stock left on the part), {} and the work frame</source>
        <translation>{}: перевірте {}, {} (припуск, лишений на деталі), {} і систему деталі</translation>
    </message>
    <message>
        <source>{}: check {}, {} and the work frame</source>
        <translation>{}: перевірте {}, {} і систему деталі</translation>
    </message>
    <message>
        <source>times {:g}</source>
        <translation>помножені на {:g}</translation>
    </message>
    <message>
        <source>the file is in inches: {}</source>
        <translation>файл у дюймах: {}</translation>
    </message>
    <message>
        <source>divided by {:g}</source>
        <translation>поділені на {:g}</translation>
    </message>
    <message>
        <source>the file is in millimetres or was converted twice: {}</source>
        <translation>файл у міліметрах або переведений двічі: {}</translation>
    </message>
    <message>
        <source>with x reversed</source>
        <translation>з оберненим x</translation>
    </message>
    <message>
        <source>with y reversed</source>
        <translation>з оберненим y</translation>
    </message>
    <message>
        <source>with x and y exchanged</source>
        <translation>з переставленими x та y</translation>
    </message>
    <message>
        <source>exchange the columns x and y</source>
        <translation>переставте стовпці x та y</translation>
    </message>
    <message>
        <source>with x and y exchanged and reversed</source>
        <translation>з переставленими й оберненими x та y</translation>
    </message>
    <message>
        <source>turned by {} degrees</source>
        <translation>повернуті на {} градусів</translation>
    </message>
    <message>
        <source>{:.0f} % of the points lie on the profile, but {} {:.0f} %</source>
        <translation>{:.0f} % точок лежать на профілі, але {} {:.0f} %</translation>
    </message>
    <message>
        <source>{}: they are contact points already: {}</source>
        <translation>{}: це вже точки дотику: {}</translation>
    </message>
    <message>
        <source>{}; check {} if that seems much</source>
        <translation>{}; перевірте {}, якщо це забагато</translation>
    </message>
    <message>
        <source>the points lie typically {} off the profile, but {} {}</source>
        <translation>точки лежать типово на {} від профілю, але {} {}</translation>
    </message>
    <message>
        <source>{:.0f} % of the contour has no measured point near, most of it between {} and {}: measure there, or say with {} how much may be left to the mean</source>
        <translation>{:.0f} % контуру не має виміряної точки поблизу, найбільше між {} і {}: виміряйте там або скажіть через {}, скільки можна лишити середньому</translation>
    </message>
    <message>
        <source>{} of {} points are outliers: clean the part and the probe, measure again</source>
        <translation>{} з {} точок є викидами: почистьте деталь і щуп та виміряйте знову</translation>
    </message>
    <message>
        <source>the wall leans: at {} it has {} more than at {} {}; one path corrects the mean of the heights: a spring pass or less overhang of the tool takes the lean away</source>
        <translation>стінка нахилена: на {} вона має на {} більше, ніж на {} {}; одна траєкторія коригує середнє висот: зачисний прохід або менший виліт інструмента знімає нахил</translation>
    </message>
    <message>
        <source>{} of {} points are outliers, the first at {}: clean the part and the probe, measure again</source>
        <translation>{} з {} точок є викидами, перша у {}: почистьте деталь і щуп та виміряйте знову</translation>
    </message>
    <message>
        <source>all along</source>
        <translation>всюди</translation>
    </message>
    <message>
        <source>at {}, {} on the average</source>
        <translation>у {}, {} у середньому</translation>
    </message>
    <message>
        <source>the ball leaves the space that the program clears, first near {}: make sure that nothing stands there, or say how far it is free with {} and lower {}</source>
        <translation>кулька виходить із простору, який звільняє програма, спершу біля {}: переконайтеся, що там нічого немає, або вкажіть через {}, наскільки там вільно, і зменште {}</translation>
    </message>
    <message>
        <source>{} is one of {}, not {!r}</source>
        <translation>{} є одним із {}, а не {!r}</translation>
    </message>
    <message>
        <source>the model has no wall on this contour: heights are judged by the passes only</source>
        <translation>модель не має стінки на цьому контурі: висоти оцінено лише за проходами</translation>
    </message>
    <message>
        <source>nothing shows that the wall stands as high as {}: the highest pass beside it runs at {}</source>
        <translation>ніщо не показує, що стінка сягає {}: найвищий прохід поруч іде на {}</translation>
    </message>
    <message>
        <source>this height is right only for a probe whose length was set to the tip of the ball, not to its centre</source>
        <translation>ця висота правильна лише для щупа, довжину якого задано до низу кульки, а не до її центра</translation>
    </message>
    <message>
        <source>this height is right only for a probe whose length was set to the centre of the ball, not to its tip</source>
        <translation>ця висота правильна лише для щупа, довжину якого задано до центра кульки, а не до її низу</translation>
    </message>
    <message>
        <source>{}: GRBL writes no file, save the log of the sender</source>
        <translation>{}: GRBL не пише файлу, збережіть журнал програми-відправника</translation>
    </message>
    <message>
        <source>{}: GRBL changes no tools, leave it out</source>
        <translation>{}: GRBL не міняє інструментів, приберіть це</translation>
    </message>
    <message>
        <source>{} touches, {} of {} ways between them over the safe height</source>
        <translation>{} дотиків, {} з {} переходів між ними через безпечну висоту</translation>
    </message>
    <message>
        <source>measured at {}, passed over at {}</source>
        <translation>вимірюється на {}, перехід на {}</translation>
    </message>
    <message>
        <source>{}: this control takes names like {}</source>
        <translation>{}: ця система ЧПК приймає імена на зразок {}</translation>
    </message>
    <message>
        <source>program name {!r}: this control takes names like {}</source>
        <translation>ім’я програми {!r}: ця система ЧПК приймає імена на зразок {}</translation>
    </message>
    <message>
        <source>{} and {} are no heights in mm</source>
        <translation>{} і {} не є висотами в мм</translation>
    </message>
    <message>
        <source>{} must lie above {}</source>
        <translation>{} має бути вище за {}</translation>
    </message>
    <message>
        <source>{} is no tool number</source>
        <translation>{} не є номером інструмента</translation>
    </message>
    <message>
        <source>points</source>
        <translation>точки</translation>
    </message>
    <message>
        <source>heights</source>
        <translation>висоти</translation>
    </message>
    <message>
        <source>{} and {} more</source>
        <translation>{} та ще {}</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>застереження</translation>
    </message>
    <message>
        <source>log</source>
        <translation>протокол</translation>
    </message>
    <message>
        <source>{} is no feed in mm/min</source>
        <translation>{} не є подачею в мм/хв</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>вилучено</translation>
    </message>
    <message>
        <source>{}: where DPRNT writes is set on the {} control</source>
        <translation>{}: куди пише DPRNT, задають на системі {}</translation>
    </message>
    <message>
        <source>{} lies below {}, a margin of {} above the deepest that the program cuts beside the contour: say {} or higher</source>
        <translation>{} нижче за {}, тобто за запас {} над найглибшим, що ріже програма біля контуру: вкажіть {} або вище</translation>
    </message>
    <message>
        <source>the program's lowest rapid across the part</source>
        <translation>найнижче прискорене переміщення програми над деталлю</translation>
    </message>
    <message>
        <source>the program's highest cut</source>
        <translation>найвище різання програми</translation>
    </message>
    <message>
        <source>the top of the model and the ball above it</source>
        <translation>верх моделі та кулька над ним</translation>
    </message>
    <message>
        <source>{} lies below {}, {}: say {} or higher</source>
        <translation>{} нижче за {}, {}: вкажіть {} або вище</translation>
    </message>
    <message>
        <source>the ball does not reach it: the contour is too hollow there, or another wall is too near</source>
        <translation>кулька туди не дістає: контур там надто увігнутий або інша стінка надто близько</translation>
    </message>
    <message>
        <source>the cutter does not reach it: its fillet stands there</source>
        <translation>фреза туди не дістає: там лишається її галтель</translation>
    </message>
    <message>
        <source>another wall is in the way of the touch</source>
        <translation>інша стінка заважає дотику</translation>
    </message>
    <message>
        <source>no wall stands there that is as high, and cut as deep, as the ball needs it</source>
        <translation>там немає стінки, настільки високої й настільки глибоко обробленої, як потрібно кульці</translation>
    </message>
    <message>
        <source>there is no room for the ball to stand clear before the touch</source>
        <translation>перед дотиком немає місця, де кулька стояла б вільно</translation>
    </message>
    <message>
        <source>near {} {}</source>
        <translation>біля {}: {}</translation>
    </message>
    <message>
        <source>no stretch</source>
        <translation>немає ділянки</translation>
    </message>
    <message>
        <source>{} and {}</source>
        <translation>{} і {}</translation>
    </message>
    <message>
        <source>no point of the contour can be touched: {}; check {}</source>
        <translation>жодної точки контуру не можна торкнутися: {}; перевірте {}</translation>
    </message>
    <message>
        <source>the stretch of {} between corners is shorter than {}</source>
        <translation>ділянка {} між кутами коротша за {}</translation>
    </message>
    <message>
        <source>no point of the contour can be touched: {} near {}; use a smaller ball</source>
        <translation>жодної точки контуру не можна торкнутися: {} біля {}; візьміть меншу кульку</translation>
    </message>
    <message>
        <source>{} makes more than {} points</source>
        <translation>{} дає понад {} точок</translation>
    </message>
    <message>
        <source>the margin {:g} at corners must lie between 0 and 1000 mm</source>
        <translation>запас {:g} біля кутів має бути від 0 до 1000 мм</translation>
    </message>
    <message>
        <source>{}: the ball and the stock do not fit in there</source>
        <translation>{}: кулька і припуск туди не вміщаються</translation>
    </message>
    <message>
        <source>give either {} or {}</source>
        <translation>вкажіть або {}, або {}</translation>
    </message>
    <message>
        <source>{} must lie between 1 and {}</source>
        <translation>{} має бути від 1 до {}</translation>
    </message>
    <message>
        <source>{} is no distance in mm</source>
        <translation>{} не є відстанню в мм</translation>
    </message>
    <message>
        <source>{}: the profile has {} contours</source>
        <translation>{}: профіль має стільки контурів: {}</translation>
    </message>
    <message>
        <source>{}: there are {} smooth stretches</source>
        <translation>{}: є стільки гладких ділянок: {}</translation>
    </message>
    <message>
        <source>{} must lie between {:g} and 1000 mm</source>
        <translation>{} має бути від {:g} до 1000 мм</translation>
    </message>
    <message>
        <source>cutting: the move that cuts at {} has no feed in mm/min: state F in G94</source>
        <translation>різання: рух, що ріже в {}, не має подачі в мм/хв: вкажіть F у G94</translation>
    </message>
    <message>
        <source>setup: [tool] overhang_mm is missing: how the tool bends along its height needs it</source>
        <translation>налаштування: немає [tool] overhang_mm: без нього не відомо, як інструмент гнеться по висоті</translation>
    </message>
    <message>
        <source>{}: [machine] stiffness_along has {:g} N/mm, of the whole loop, tool included, but the tool alone has {:.0f} N/mm at its tip: correct [tool] overhang_mm, youngs_modulus_gpa or stiffness_n_per_mm</source>
        <translation>{}: [machine] stiffness_along має {:g} Н/мм для всього силового контуру разом з інструментом, але сам інструмент має {:.0f} Н/мм на кінці: виправте [tool] overhang_mm, youngs_modulus_gpa або stiffness_n_per_mm</translation>
    </message>
    <message>
        <source>setup: [machine] {} {:g} N/mm is of the whole loop, tool included, but the tool alone has {:.0f} N/mm at its tip: correct [tool] overhang_mm, youngs_modulus_gpa or stiffness_n_per_mm, or leave the key out for a rigid machine</source>
        <translation>налаштування: [machine] {} {:g} Н/мм стосується всього силового контуру разом з інструментом, але сам інструмент має {:.0f} Н/мм на кінці: виправте [tool] overhang_mm, youngs_modulus_gpa або stiffness_n_per_mm, або приберіть ключ для жорсткого верстата</translation>
    </message>
    <message>
        <source>predicted deviation: the path cuts away again all that it makes</source>
        <translation>передбачене відхилення: траєкторія знову зрізає все, що створює</translation>
    </message>
    <message>
        <source>wall error: the deflection does not settle near {}, it still changes by {}; check [tool] overhang_mm, [material] and the radial depth of cut</source>
        <translation>похибка стінки: прогин біля {} не встановлюється, він ще змінюється на {}; перевірте [tool] overhang_mm, [material] і радіальну глибину різання</translation>
    </message>
    <message>
        <source>wall error: the program makes no wall: it cuts only slots or air</source>
        <translation>похибка стінки: програма не робить стінки: вона ріже лише пази або повітря</translation>
    </message>
    <message>
        <source>wall error: the program makes no wall {} above its deepest tip</source>
        <translation>похибка стінки: програма не робить стінки на {} над найнижчим положенням інструмента</translation>
    </message>
    <message>
        <source>{}: no move cuts in the XY plane at constant height</source>
        <translation>{}: жоден рух не ріже в площині XY на сталій висоті</translation>
    </message>
    <message>
        <source>{}: no move that cuts in the XY plane can be followed</source>
        <translation>{}: жоден рух, що ріже в площині XY, не можна простежити</translation>
    </message>
    <message>
        <source>tilt: the slope of the wall needs two heights at least</source>
        <translation>нахил: нахил стінки потребує щонайменше двох висот</translation>
    </message>
    <message>
        <source>tilt: the program makes no wall within {} of the nominal: check {}</source>
        <translation>нахил: програма не робить стінки в межах {} від номіналу: перевірте {}</translation>
    </message>
    <message>
        <source>mean shift: the program makes no wall within {} of the nominal: check {}</source>
        <translation>середній зсув: програма не робить стінки в межах {} від номіналу: перевірте {}</translation>
    </message>
    <message>
        <source>tilt: the walls are cut in passes of several depths: only walls of one depth are tilted</source>
        <translation>нахил: стінки ріжуться проходами різної глибини: нахиляють лише стінки однієї глибини</translation>
    </message>
    <message>
        <source>tilt: a stretch is cut at fewer than two of the heights: give heights within its depth</source>
        <translation>нахил: ділянка ріжеться менш ніж на двох із висот: вкажіть висоти в межах її глибини</translation>
    </message>
    <message>
        <source>stretch {} ({}): at most {} off over the heights; shift {}: {}; shift and tilt {:+.4f} deg: {}, and the tilted end face digs {} below the tip</source>
        <translation>ділянка {} ({}): щонайбільше {} похибки за висотами; зсув {}: {}; зсув і нахил {:+.4f}°: {}, а нахилений торець заглиблюється на {} нижче кінчика</translation>
    </message>
    <message>
        <source>{}: the program cuts with G41 or G42, so it does not say where the cutter's centre goes: give a program of the centre path</source>
        <translation>{}: програма ріже з G41 або G42, тож не каже, де йде центр фрези: дайте програму траєкторії центра</translation>
    </message>
    <message>
        <source>{}: engagement needs arcs in the XY plane (G17); the program has others that cut</source>
        <translation>{}: для зачеплення потрібні дуги в площині XY (G17); програма має інші, що ріжуть</translation>
    </message>
    <message>
        <source>{}: line {} cuts from a place the program has not stated: state X and Y before it</source>
        <translation>{}: рядок {} ріже з місця, якого програма не вказала: вкажіть перед ним X і Y</translation>
    </message>
    <message>
        <source>the curve near {} bends too sharply to be followed</source>
        <translation>крива біля {} вигнута надто різко, щоб за нею йти</translation>
    </message>
    <message>
        <source>load ratio: the cutter takes nothing at {}, where the part was touched</source>
        <translation>відношення навантажень: фреза нічого не знімає в {}, де деталі торкнулися</translation>
    </message>
    <message>
        <source>load ratio: the program cuts only air</source>
        <translation>відношення навантажень: програма ріже лише повітря</translation>
    </message>
    <message>
        <source>engagement: the program states no Z: give [stock] axial_depth_mm in place of top_z_mm</source>
        <translation>зачеплення: програма не вказує Z: дайте [stock] axial_depth_mm замість top_z_mm</translation>
    </message>
    <message>
        <source>engagement: the program stays above the stock's face at {}: check [stock] top_z_mm</source>
        <translation>зачеплення: програма лишається над поверхнею заготовки в {}: перевірте [stock] top_z_mm</translation>
    </message>
    <message>
        <source>engagement: the program cuts at {} heights, more than {}: it is no flank milling</source>
        <translation>зачеплення: програма ріже на {} висотах, більше ніж {}: це не бокове фрезерування</translation>
    </message>
    <message>
        <source>engagement: the program cuts with several tools ({}): give the moves of one</source>
        <translation>зачеплення: програма ріже кількома інструментами ({}): дайте рухи одного</translation>
    </message>
    <message>
        <source>engagement: the program has no cutting move in the XY plane</source>
        <translation>зачеплення: програма не має руху різання в площині XY</translation>
    </message>
    <message>
        <source>setup: [stock] allowance_mm needs the nominal profile it lies on</source>
        <translation>налаштування: для [stock] allowance_mm потрібен номінальний профіль, на якому лежить припуск</translation>
    </message>
    <message>
        <source>acc/dec time {:g} s: state 0, or {:g} s or more</source>
        <translation>час розгону {:g} с: вкажіть 0 або {:g} с чи більше</translation>
    </message>
    <message>
        <source>servo gain {:g} 1/s: state a gain above 0 up to {:g}, or leave it out for an ideal servo</source>
        <translation>підсилення привода {:g} 1/с: вкажіть понад 0 до {:g}, або приберіть його для ідеального привода</translation>
    </message>
    <message>
        <source>rapid speed {:g} mm/s: state a speed above 0, or leave it out</source>
        <translation>швидкий хід {:g} мм/с: вкажіть швидкість понад 0 або приберіть</translation>
    </message>
    <message>
        <source>speed change at corners {:g} mm/s: state a speed above 0</source>
        <translation>стрибок швидкості в кутах {:g} мм/с: вкажіть швидкість понад 0</translation>
    </message>
    <message>
        <source>accuracy-maintenance time: slope and intercept are 0 or more, and not both 0</source>
        <translation>час утримання точності: нахил і зсув не менші за 0 і не обидва 0</translation>
    </message>
    <message>
        <source>in-position width {}: state a width above 0</source>
        <translation>вікно позиціювання {}: вкажіть ширину понад 0</translation>
    </message>
    <message>
        <source>this dwell cannot be read: state one of P, X or U</source>
        <translation>цю витримку не прочитати: вкажіть одне з P, X або U</translation>
    </message>
    <message>
        <source>controls differ on whether {}{:g} are seconds or milliseconds: state the unit of dwells</source>
        <translation>системи ЧПК розуміють {}{:g} по-різному, секунди чи мілісекунди: вкажіть одиницю витримок</translation>
    </message>
    <message>
        <source>line {}: this curve bends too sharply to be followed; write it as lines or arcs</source>
        <translation>рядок {}: ця крива вигнута надто різко, щоб за нею йти; запишіть її прямими або дугами</translation>
    </message>
    <message>
        <source>{}: no move can be followed</source>
        <translation>{}: жодного руху не можна простежити</translation>
    </message>
    <message>
        <source>combined control: no stiffness makes the model leave what was touched, {} are still missing: check {}, [stock] and [material]</source>
        <translation>комбінований: за жодної жорсткості модель не лишає того, що виміряно дотиком, ще бракує {}: перевірте {}, [stock] і [material]</translation>
    </message>
    <message>
        <source>at {} a point was touched where the program takes nothing off the stock of the setup: check [stock] and {}</source>
        <translation>біля {} торкнулися точки, де програма нічого не знімає із заготовки налаштування: перевірте [stock] і {}</translation>
    </message>
    <message>
        <source>at {} {} of a depth of {} stayed: MS = delta/(h - delta) has no meaning there; check {} or [stock]</source>
        <translation>біля {} лишилося {} з глибини {}: MS = delta/(h - delta) там не має змісту; перевірте {} або [stock]</translation>
    </message>
    <message>
        <source>combined control: the model has no force across the walls that were touched</source>
        <translation>комбінований: модель не має сили впоперек виміряних стінок</translation>
    </message>
    <message>
        <source>combined control: the touches show the cutter moved against the force of the model (mean deviation {}): check [tool] rotation, the cutter's side and {}; or take the deviations as they are: {}</source>
        <translation>комбінований: дотики показують, що фреза змістилася проти сили моделі (середнє відхилення {}): перевірте [tool] rotation, бік фрези та {}; або візьміть відхилення як є: {}</translation>
    </message>
    <message>
        <source>corner bound {}: state a length above 0</source>
        <translation>межа похибки кута {}: вкажіть довжину понад 0</translation>
    </message>
    <message>
        <source>{}:{}: the corner is off by {} and cannot be slowed: {}; lower the feed there, raise the bound, or accept it as it is</source>
        <translation>{}:{}: похибка кута {}, і сповільнити його не можна: {}; зменште там подачу, збільште межу або прийміть як є</translation>
    </message>
    <message>
        <source>{}:{}: the slowed corner is still off by {}, more than {}</source>
        <translation>{}:{}: сповільнений кут усе ще має похибку {}, більше за {}</translation>
    </message>
    <message>
        <source>one of its blocks is a spline</source>
        <translation>один із його кадрів є сплайном</translation>
    </message>
    <message>
        <source>the feed would be below the smallest step of a feed</source>
        <translation>подача була б меншою за найменший крок подачі</translation>
    </message>
    <message>
        <source>{}: the slowed program does not read back as it was meant; raise the bound</source>
        <translation>{}: сповільнена програма читається не так, як задумано; збільште межу</translation>
    </message>
    <message>
        <source>its blocks are too short for the control to change the feed in them</source>
        <translation>її кадри закороткі, щоб система ЧПК змінила в них подачу</translation>
    </message>
    <message>
        <source>its error does not fall with the feed</source>
        <translation>її похибка не зменшується з подачею</translation>
    </message>
    <message>
        <source>{}: a corner is lost in the slowed program; raise the bound</source>
        <translation>{}: у сповільненій програмі втрачено кут; збільште межу</translation>
    </message>
    <message>
        <source>elastic loop: it does not settle near {}, where force and deflection still differ by {}; check [machine] stiffness, feed and [material]</source>
        <translation>пружний контур: біля {} він не встановлюється, сила і прогин ще різняться на {}; перевірте жорсткість [machine], подачу і [material]</translation>
    </message>
    <message>
        <source>elastic loop: the cut is {:.2f} times as stiff as the machine ({:g} N/mm): it need not settle; check [machine] kx_n_per_mm and ky_n_per_mm, feed, axial depth and [material]</source>
        <translation>пружний контур: різання в {:.2f} раза жорсткіше за верстат ({:g} Н/мм): воно може не встановитися; перевірте [machine] kx_n_per_mm і ky_n_per_mm, подачу, осьову глибину та [material]</translation>
    </message>
    <message>
        <source>predicted deviation: a spacing of {!r} mm is not positive</source>
        <translation>передбачене відхилення: крок {!r} мм не додатний</translation>
    </message>
    <message>
        <source>predicted deviation: the program does not cut the nominal profile: check both</source>
        <translation>передбачене відхилення: програма не ріже номінального профілю: перевірте обидва</translation>
    </message>
    <message>
        <source>predicted deviation: nothing cuts at or below {}</source>
        <translation>передбачене відхилення: ніщо не ріже на {} або нижче</translation>
    </message>
    <message>
        <source>predicted deviation: what the cutter leaves at {} is not to be found within {}; it is up to {} off its path: check [machine] stiffness and inertia</source>
        <translation>передбачене відхилення: що лишає фреза біля {}, не знайти в межах {}; вона до {} від своєї траєкторії: перевірте жорсткість та інерцію [machine]</translation>
    </message>
    <message>
        <source>{}: [machine] states all that a trace can tell: name with {} what is to be identified anew</source>
        <translation>{}: [machine] задає все, що може показати запис: назвіть через {}, що визначити наново</translation>
    </message>
    <message>
        <source>the model leaves at most {} before and {} after the correction{}</source>
        <translation>модель лишає щонайбільше {} до корекції і {} після неї{}</translation>
    </message>
    <message>
        <source>{} needs {}: tool, material, machine and stock</source>
        <translation>{} потребує {}: інструмент, матеріал, верстат і заготовка</translation>
    </message>
    <message>
        <source>{}: [tool] diameter_mm {:g} is not the tool diameter of the program, {:g}</source>
        <translation>{}: [tool] diameter_mm {:g} не є діаметром інструмента програми, {:g}</translation>
    </message>
    <message>
        <source>the touches do not tell the axes apart: both are taken as equally stiff</source>
        <translation>дотики не розрізняють осей: обидві вважаються однаково жорсткими</translation>
    </message>
    <message>
        <source>{} takes parts of one depth; for several depths use {}</source>
        <translation>{} приймає деталі однієї глибини; для кількох глибин візьміть {}</translation>
    </message>
    <message>
        <source>{} needs {}: the stock of the setup is no even allowance_mm</source>
        <translation>{} потребує {}: заготовка налаштування не є рівномірним allowance_mm</translation>
    </message>
    <message>
        <source>{} is no part of [stock] allowance_mm {:g}, which the first cut started from</source>
        <translation>{} не є частиною [stock] allowance_mm {:g}, з якого почався перший прохід</translation>
    </message>
    <message>
        <source>nothing was measured: the size of the correction is the model's alone; touch the first part</source>
        <translation>нічого не виміряно: величина корекції лише з моделі; виміряйте дотиком першу деталь</translation>
    </message>
    <message>
        <source>transfer function of the axes at the first touch: MSx {:.4f}, MSy {:.4f}</source>
        <translation>передавальна функція осей за першим дотиком: MSx {:.4f}, MSy {:.4f}</translation>
    </message>
    <message>
        <source>at {} a point was touched that the simulated program does not cut</source>
        <translation>біля {} торкнулися точки, якої змодельована програма не ріже</translation>
    </message>
    <message>
        <source>the touches do not tell the rows of [machine] stiffness_along apart: all are off by one factor; touch at each of its places</source>
        <translation>дотики не розрізняють рядків [machine] stiffness_along: усі різняться одним множником; торкніться в кожному з їхніх місць</translation>
    </message>
    <message>
        <source>, in {} rounds</source>
        <translation>, за {} проходів розрахунку</translation>
    </message>
    <message>
        <source>[machine] position_gain_per_s {:g} is above 1000 (1/s)</source>
        <translation>[machine] position_gain_per_s {:g} перевищує 1000 (1/с)</translation>
    </message>
    <message>
        <source>[machine] {} {:g} is neither 0 nor at least 1 (ms)</source>
        <translation>[machine] {} {:g} не є ні 0, ні щонайменше 1 (мс)</translation>
    </message>
    <message>
        <source>[machine] contour_time_offset_ms and contour_time_slope_ms_per_mm_min are both 0: contour control takes its time</source>
        <translation>[machine] contour_time_offset_ms і contour_time_slope_ms_per_mm_min обидва 0: контурне керування потребує часу</translation>
    </message>
    <message>
        <source>after {} {} are still predicted at {}, more than {}</source>
        <translation>після {} усе ще передбачено {} біля {}, більше за {}</translation>
    </message>
    <message>
        <source>{}: the cutter cannot follow so quick a change; allow more</source>
        <translation>{}: фреза не може йти за такою швидкою зміною; дозвольте більше</translation>
    </message>
    <message>
        <source>1 round</source>
        <translation>1 проходу розрахунку</translation>
    </message>
    <message>
        <source>{} rounds</source>
        <translation>{} проходів розрахунку</translation>
    </message>
    <message>
        <source>{}, which the axes leave: lower the feed there (simulate {})</source>
        <translation>{}, і це від осей: зменште там подачу (симуляція з {})</translation>
    </message>
    <message>
        <source>{}: the unit of the dwells is not known, they are taken as seconds</source>
        <translation>{}: одиниця витримок невідома, їх узято за секунди</translation>
    </message>
    <message>
        <source>cutting coefficients of {} are not calibrated on this machine ({}): forces are good to a factor of two</source>
        <translation>коефіцієнти різання для {} не відкалібровано на цьому верстаті ({}): сили точні до множника два</translation>
    </message>
    <message>
        <source>stiffness of {:g} and {:g} N/mm: {}</source>
        <translation>жорсткість {:g} і {:g} Н/мм: {}</translation>
    </message>
    <message>
        <source>: is it {}?</source>
        <translation>: це {}?</translation>
    </message>
    <message>
        <source>, known are {}</source>
        <translation>, відомі {}</translation>
    </message>
    <message>
        <source>GPa: 600 for carbide, 210 for high-speed steel</source>
        <translation>ГПа: 600 для твердого сплаву, 210 для швидкорізальної сталі</translation>
    </message>
    <message>
        <source>N/mm: an end mill has 500 to 100000 (1 N/um = 1000 N/mm)</source>
        <translation>Н/мм: кінцева фреза має від 500 до 100000 (1 Н/мкм = 1000 Н/мм)</translation>
    </message>
    <message>
        <source>mm, not um</source>
        <translation>мм, не мкм</translation>
    </message>
    <message>
        <source>N/mm2: 500 to 5000 for metals</source>
        <translation>Н/мм²: від 500 до 5000 для металів</translation>
    </message>
    <message>
        <source>N/mm (1 N/um = 1000 N/mm)</source>
        <translation>Н/мм (1 Н/мкм = 1000 Н/мм)</translation>
    </message>
    <message>
        <source>mm/min: the feed difference that the control allows at a corner</source>
        <translation>мм/хв: різниця подач, яку система ЧПК дозволяє в куті</translation>
    </message>
    <message>
        <source>1/s, not (m/min)/mm: Kv 1 is 16.67/s</source>
        <translation>1/с, не (м/хв)/мм: Kv 1 — це 16,67/с</translation>
    </message>
    <message>
        <source>{} is none of {}</source>
        <translation>{} не є одним із {}</translation>
    </message>
    <message>
        <source>the material</source>
        <translation>матеріалу</translation>
    </message>
    <message>
        <source>origin not stated</source>
        <translation>походження не вказано</translation>
    </message>
    <message>
        <source>{}: [machine] {} is missing: deflection needs the stiffness of both axes</source>
        <translation>{}: бракує [machine] {}: прогин потребує жорсткості обох осей</translation>
    </message>
    <message>
        <source>[stock] is missing: give allowance_mm, contour, program or solid = true</source>
        <translation>бракує [stock]: вкажіть allowance_mm, contour, program або solid = true</translation>
    </message>
    <message>
        <source>[stock] {} and {} say the same twice: give one of them</source>
        <translation>[stock] {} і {} кажуть те саме: вкажіть одне з них</translation>
    </message>
    <message>
        <source>[stock] program_tool_diameter_mm goes with program, which is missing</source>
        <translation>[stock] program_tool_diameter_mm іде разом із program, якого бракує</translation>
    </message>
    <message>
        <source>[stock] end = "{}" goes with allowance_mm or contour, one is missing</source>
        <translation>[stock] end = "{}" іде разом з allowance_mm або contour, одного з них бракує</translation>
    </message>
    <message>
        <source>[stock] top_z_mm or axial_depth_mm is needed, one of them: it says how deep the tool cuts</source>
        <translation>потрібне [stock] top_z_mm або axial_depth_mm, одне з них: воно каже, як глибоко ріже інструмент</translation>
    </message>
    <message>
        <source>[machine] contour_speed_change_mm_min is missing: contour_control needs the speed change allowed at a corner</source>
        <translation>бракує [machine] contour_speed_change_mm_min: contour_control потребує зміни швидкості, дозволеної в куті</translation>
    </message>
    <message>
        <source>[tool] overhang_mm {:g} is more than 40 diameters: is its unit mm?</source>
        <translation>[tool] overhang_mm {:g} — це понад 40 діаметрів: одиниця — мм?</translation>
    </message>
    <message>
        <source>[tool] overhang_mm {:g} is shorter than the cut of {}</source>
        <translation>[tool] overhang_mm {:g} менше за різання {}</translation>
    </message>
    <message>
        <source>too large for a setup</source>
        <translation>завеликий для налаштування</translation>
    </message>
    <message>
        <source>not TOML: {}</source>
        <translation>не TOML: {}</translation>
    </message>
    <message>
        <source>[{}] is unknown{}</source>
        <translation>[{}] невідоме{}</translation>
    </message>
    <message>
        <source>[{}] is a table of keys</source>
        <translation>[{}] є таблицею ключів</translation>
    </message>
    <message>
        <source>[material] {} is missing: ks_n_per_mm2 and mu go together</source>
        <translation>бракує [material] {}: ks_n_per_mm2 і mu йдуть разом</translation>
    </message>
    <message>
        <source>[material] {} {!r} is not a number from {:g} to {:g}</source>
        <translation>[material] {} {!r} не є числом від {:g} до {:g}</translation>
    </message>
    <message>
        <source>[material] {} and ks_n_per_mm2 say the same twice: give one of them</source>
        <translation>[material] {} і ks_n_per_mm2 кажуть те саме: вкажіть одне з них</translation>
    </message>
    <message>
        <source>[{}] {} is unknown{}</source>
        <translation>[{}] {} невідоме{}</translation>
    </message>
    <message>
        <source>[{}] {} is missing</source>
        <translation>бракує [{}] {}</translation>
    </message>
    <message>
        <source>{}: {!r} is no row [mm, kx_n_per_mm, ky_n_per_mm]</source>
        <translation>{}: {!r} не є рядком [mm, kx_n_per_mm, ky_n_per_mm]</translation>
    </message>
    <message>
        <source>{}: {!r}: stiffness is above 1 and at most 1e+07 N/mm</source>
        <translation>{}: {!r}: жорсткість більша за 1 і щонайбільше 1e+07 Н/мм</translation>
    </message>
    <message>
        <source>[material] {} is missing: give ktc_n_per_mm2 and krc_n_per_mm2, or ks_n_per_mm2 and mu</source>
        <translation>бракує [material] {}: вкажіть ktc_n_per_mm2 і krc_n_per_mm2 або ks_n_per_mm2 і mu</translation>
    </message>
    <message>
        <source>{} is not a whole number{}</source>
        <translation>{} не є цілим числом{}</translation>
    </message>
    <message>
        <source>{} is not a number{}</source>
        <translation>{} не є числом{}</translation>
    </message>
    <message>
        <source>{} is not {}{}{}</source>
        <translation>{} не {}{}{}</translation>
    </message>
    <message>
        <source>[machine] {}: {} is 0 or more and ascends, {:g} does not</source>
        <translation>[machine] {}: {} не менше 0 і зростає, {:g} — ні</translation>
    </message>
    <message>
        <source>{} is not true or false</source>
        <translation>{} не є true чи false</translation>
    </message>
    <message>
        <source>{} is not the name of a file</source>
        <translation>{} не є іменем файлу</translation>
    </message>
    <message>
        <source>{} is not a text</source>
        <translation>{} не є текстом</translation>
    </message>
    <message>
        <source>{}: [machine] stiffness_along needs a nominal of one contour, which it goes along</source>
        <translation>{}: [machine] stiffness_along потребує номіналу з одним контуром, уздовж якого воно діє</translation>
    </message>
    <message>
        <source>{}: [machine] stiffness_along goes to {}, the contour is {} long</source>
        <translation>{}: [machine] stiffness_along сягає {}, а контур має довжину {}</translation>
    </message>
    <message>
        <source>NOT CORRECTED</source>
        <translation>НЕ СКОРИГОВАНО</translation>
    </message>
    <message>
        <source>corrected</source>
        <translation>скориговано</translation>
    </message>
    <message>
        <source>corrected by its own deviation</source>
        <translation>скориговано за її власним відхиленням</translation>
    </message>
    <message>
        <source>corrected by the smoothed deviation</source>
        <translation>скориговано за згладженим відхиленням</translation>
    </message>
    <message>
        <source>PENDING: the next run that uses the journal settles it</source>
        <translation>НЕЗАВЕРШЕНО: це вирішить наступний запуск із цим журналом</translation>
    </message>
    <message>
        <source>{} is no table of a journal and stays untouched: name another file</source>
        <translation>{} не є таблицею журналу і лишається як є: назвіть інший файл</translation>
    </message>
    <message>
        <source>{} is a directory; name a file</source>
        <translation>{} є каталогом; назвіть файл</translation>
    </message>
    <message>
        <source>{}: there is no directory {}: make it first</source>
        <translation>{}: немає каталогу {}: спершу створіть його</translation>
    </message>
    <message>
        <source>{}: the journal cannot be written: no permission</source>
        <translation>{}: журнал записати не можна: немає дозволу</translation>
    </message>
    <message>
        <source>{}: there is no such journal</source>
        <translation>{}: такого журналу немає</translation>
    </message>
    <message>
        <source>an SQLite file of another program, not a journal of millcorr</source>
        <translation>файл SQLite іншої програми, не журнал millcorr</translation>
    </message>
    <message>
        <source>written by a newer millcorr (journal version {}, this one knows {}): update millcorr</source>
        <translation>записано новішим millcorr (версія журналу {}, цей знає {}): оновіть millcorr</translation>
    </message>
    <message>
        <source>the journal is damaged ({}): restore it from a copy</source>
        <translation>журнал пошкоджено ({}): відновіть його з копії</translation>
    </message>
    <message>
        <source>{}: not what the journal {} announced; part {} was not recorded</source>
        <translation>{}: не те, що оголосив журнал {}; деталь {} не записано</translation>
    </message>
    <message>
        <source>{}: the journal cannot be read or written ({})</source>
        <translation>{}: журнал не вдається прочитати або записати ({})</translation>
    </message>
    <message>
        <source>not a journal of millcorr, or damaged ({}): give the journal, or restore it from a copy</source>
        <translation>не журнал millcorr або пошкоджено ({}): вкажіть журнал або відновіть його з копії</translation>
    </message>
    <message>
        <source>{}: this measurement is part {} of {} already (as {} on {}, for {}); measure a new part</source>
        <translation>{}: це вимірювання вже є деталлю {} у {} (як {}, {}, для {}); виміряйте нову деталь</translation>
    </message>
    <message>
        <source>{}: another run has held the journal for too long; try again when it is done</source>
        <translation>{}: інший процес надто довго тримає журнал; спробуйте ще раз, коли він закінчить</translation>
    </message>
    <message>
        <source>the smoothed deviation of a series is damaged ({}): correct from the part again</source>
        <translation>згладжене відхилення серії пошкоджено ({}): скоригуйте ще раз за деталлю</translation>
    </message>
    <message>
        <source>the smoothed deviation, {} at most, is beyond the limit of {}</source>
        <translation>згладжене відхилення, щонайбільше {}, перевищує межу {}</translation>
    </message>
    <message>
        <source>the smoothed deviation, {} at most, is within the limit of {}</source>
        <translation>згладжене відхилення, щонайбільше {}, у межах {}</translation>
    </message>
    <message>
        <source>{}: write ewma:K, such as ewma:2, K being how many parts are smoothed over</source>
        <translation>{}: пишіть ewma:K, наприклад ewma:2, де K — за скількома деталями згладжувати</translation>
    </message>
    <message>
        <source>the part is {} off, more than {}: this cannot be a part of this program; nothing was recorded or written</source>
        <translation>деталь відхиляється на {}, більше за {}: це не може бути деталь цієї програми; нічого не записано</translation>
    </message>
    <message>
        <source>the part is {} off, more than {}: look for the cause; if it is real and stays (a new tool), {} corrects it; nothing was recorded or written</source>
        <translation>деталь відхиляється на {}, більше за {}: шукайте причину; якщо вона справжня й тривала (новий інструмент), {} її скоригує; нічого не записано</translation>
    </message>
    <message>
        <source>the part itself is {} off, beyond the tolerance of {}: corrected by its own deviation</source>
        <translation>сама деталь відхиляється на {}, понад допуск {}: скориговано за її власним відхиленням</translation>
    </message>
    <message>
        <source>first correction: the deviation, {} at most, is beyond the limit of {}</source>
        <translation>перша корекція: відхилення, щонайбільше {}, перевищує межу {}</translation>
    </message>
    <message>
        <source>the deviation, {} at most, is within the limit of {}</source>
        <translation>відхилення, щонайбільше {}, у межах {}</translation>
    </message>
    <message>
        <source>one correction would move the contour</source>
        <translation>одна корекція змістила б контур</translation>
    </message>
    <message>
        <source>look for what jumped</source>
        <translation>шукайте, що стрибнуло</translation>
    </message>
    <message>
        <source>all corrections together would move the contour</source>
        <translation>усі корекції разом змістили б контур</translation>
    </message>
    <message>
        <source>change the tool</source>
        <translation>замініть інструмент</translation>
    </message>
    <message>
        <source>{}: K must be 1 or more</source>
        <translation>{}: K має бути не менше 1</translation>
    </message>
    <message>
        <source>{}: must not be negative</source>
        <translation>{}: не може бути від’ємним</translation>
    </message>
    <message>
        <source>{} needs {}: the program stays as it is within it</source>
        <translation>{} потребує {}: у цих межах програма лишається як є</translation>
    </message>
    <message>
        <source>{} must not be above {}</source>
        <translation>{} не може перевищувати {}</translation>
    </message>
    <message>
        <source>{} by {}, more than {}: {}, or raise the limit; nothing was recorded or written</source>
        <translation>{} на {}, більше за {}: {} або збільште межу; нічого не записано</translation>
    </message>
    <message>
        <source>{}: must be above 0</source>
        <translation>{}: має бути понад 0</translation>
    </message>
    <message>
        <source>{} must be below {}: dead band &lt; limit &lt; tolerance &lt; alarm &lt; abort</source>
        <translation>{} має бути менше за {}: зона нечутливості &lt; межа &lt; допуск &lt; тривога &lt; зупинка</translation>
    </message>
    <message>
        <source>{} needs {}, how far the tool may pass a corner</source>
        <translation>{} потребує {}, наскільки інструмент може розминутися з кутом</translation>
    </message>
    <message>
        <source>{}: {} needs [machine] acceleration_time_x_ms, acceleration_time_y_ms or position_gain_per_s: without inertia no corner is rounded off</source>
        <translation>{}: {} потребує [machine] acceleration_time_x_ms, acceleration_time_y_ms або position_gain_per_s: без інерції жоден кут не заокруглюється</translation>
    </message>
    <message>
        <source>{}: the moved path no longer makes the same walls: nothing is written</source>
        <translation>{}: зміщена траєкторія вже не робить тих самих стінок: нічого не записано</translation>
    </message>
    <message>
        <source>{}: the tilted program does not read back as it was meant: nothing is written</source>
        <translation>{}: програма з нахилом читається не так, як задумано: нічого не записано</translation>
    </message>
    <message>
        <source>the last {} parts share a form of up to {} that none of them shows alone (they scatter by {}): it stays in the next part; {} {} takes it out</source>
        <translation>останні {} деталі мають спільну форму до {}, якої жодна з них окремо не показує (їхній розкид {}): вона лишиться в наступній деталі; {} {} її усуне</translation>
    </message>
    <message>
        <source>{} needs {}: what earlier parts have shown is kept there</source>
        <translation>{} потребує {}: там зберігається, що показали попередні деталі</translation>
    </message>
    <message>
        <source>{} keeps measured parts: nothing was measured</source>
        <translation>{} зберігає виміряні деталі: нічого не виміряно</translation>
    </message>
    <message>
        <source>{}: {} goes on from {}; since {} it was corrected by part {} on {}, and correcting again from a part of the earlier program would count its error twice: measure a part cut with {}</source>
        <translation>{}: {} продовжується від {}; відтоді {} скориговано деталлю {} {}, і корекція ще раз за деталлю попередньої програми врахувала б її похибку двічі: виміряйте деталь, оброблену за {}</translation>
    </message>
    <message>
        <source>{}: it carries a correction (measurement {}) that {} does not know; begin a new journal with {}</source>
        <translation>{}: програма має корекцію (вимірювання {}), якої {} не знає; почніть новий журнал через {}</translation>
    </message>
    <message>
        <source>{}: the nominal has other contours or lengths than in {}: give the same {} and measure the same contours on every part, or begin a new journal with {}</source>
        <translation>{}: номінал має інші контури чи довжини, ніж у {}: вкажіть той самий {} і вимірюйте на кожній деталі ті самі контури або почніть новий журнал через {}</translation>
    </message>
    <message>
        <source>{} goes with {} or transfer, not with {}: it smooths what whole contours have shown over the parts, not what a model expects</source>
        <translation>{} поєднується з {} або передачею, а не з {}: воно згладжує те, що показали цілі контури на деталях, а не те, чого чекає модель</translation>
    </message>
    <message>
        <source>{} watches a series of finished parts: it does not go with {}</source>
        <translation>{} стежить за серією готових деталей: воно не поєднується з {}</translation>
    </message>
    <message>
        <source>{} smooths over parts that are cut alike: give one {} and no other {}; for a new depth correct once without {}</source>
        <translation>{} згладжує за деталями, обробленими однаково: вкажіть одне {} і жодного іншого {}; для нової глибини скоригуйте раз без {}</translation>
    </message>
    <message>
        <source>corrected as the settings say</source>
        <translation>скориговано, як кажуть налаштування</translation>
    </message>
    <message>
        <source>nothing is to be corrected</source>
        <translation>коригувати нічого</translation>
    </message>
    <message>
        <source>NOT CORRECTED: {}; the output is the very bytes of {}</source>
        <translation>НЕ СКОРИГОВАНО: {}; вихідний файл побайтово такий, як {}</translation>
    </message>
    <message>
        <source>{} belongs to {}</source>
        <translation>{} належить до {}</translation>
    </message>
    <message>
        <source>corrected: {}</source>
        <translation>скориговано: {}</translation>
    </message>
    <message>
        <source>{} needs {} at two heights at least: the tool leans by the wall's slope</source>
        <translation>{} потребує {} щонайменше на двох висотах: інструмент нахиляється на нахил стінки</translation>
    </message>
    <message>
        <source>{} needs {}: the contour is moved by the wall's mean error over them</source>
        <translation>{} потребує {}: контур зміщується на середню похибку стінки за ними</translation>
    </message>
    <message>
        <source>tilt: {}</source>
        <translation>нахил: {}</translation>
    </message>
    <message>
        <source>{} belongs to {}, the log that tells</source>
        <translation>{} належить до {}, запису, який це показує</translation>
    </message>
    <message>
        <source>{} belongs to {}, the program that keeps it</source>
        <translation>{} належить до {}, програми, яка її дотримує</translation>
    </message>
    <message>
        <source>{}: the allowance must be above 0</source>
        <translation>{}: припуск має бути понад 0</translation>
    </message>
    <message>
        <source>{}: the first cut takes a share between 0 and 1</source>
        <translation>{}: перший прохід бере частку від 0 до 1</translation>
    </message>
    <message>
        <source>{}:{}: the program was corrected before; split the first, uncorrected one</source>
        <translation>{}:{}: програму вже скориговано; діліть першу, нескориговану</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>середнього</translation>
    </message>
    <message>
        <source>place X</source>
        <translation>положення за X</translation>
    </message>
    <message>
        <source>place Y</source>
        <translation>положення за Y</translation>
    </message>
    <message>
        <source>form</source>
        <translation>форми</translation>
    </message>
    <message>
        <source>tool wear or warming</source>
        <translation>знос інструмента або нагрівання</translation>
    </message>
    <message>
        <source>warming of the machine or of the fixture</source>
        <translation>нагрівання верстата або пристрою</translation>
    </message>
    <message>
        <source>wear or warming that is not the same all along the contour</source>
        <translation>знос або нагрівання, неоднакові вздовж контуру</translation>
    </message>
    <message>
        <source>another tool, another stock, or a clamping that bends the part</source>
        <translation>інший інструмент, інша заготовка або затиск, що гне деталь</translation>
    </message>
    <message>
        <source>a new tool, another offset or another batch of material</source>
        <translation>новий інструмент, інший коректор або інша партія матеріалу</translation>
    </message>
    <message>
        <source>a chip at the stop, another clamping or another datum</source>
        <translation>стружка на упорі, інше закріплення або інша база</translation>
    </message>
    <message>
        <source>jump of the {} by {} before part {} (p {:.1g}): {}</source>
        <translation>стрибок {} на {} перед деталлю {} (p {:.1g}): {}</translation>
    </message>
    <message>
        <source>drift of the {} by {} a part from part {} to {} (+- {}, p {:.1g}): {}</source>
        <translation>дрейф {} на {} за деталь від деталі {} до {} (± {}, p {:.1g}): {}</translation>
    </message>
    <message>
        <source>{}; one part shows it so far, measure another</source>
        <translation>{}; поки це показує одна деталь, виміряйте ще одну</translation>
    </message>
    <message>
        <source>No remedy: a slope needs two heights at least, give {} again.</source>
        <translation>Немає поради: нахил потребує щонайменше двох висот, вкажіть {} ще раз.</translation>
    </message>
    <message>
        <source>{}: heights count from the tool's tip upwards, in mm: give 0 or more</source>
        <translation>{}: висоти рахують у мм від кінчика інструмента вгору: вкажіть 0 або більше</translation>
    </message>
    <message>
        <source>{}: {} cuts its wall up to {} above the tool's tip: give 0 to {:g}, or correct [stock] in {}</source>
        <translation>{}: {} ріже стінку до {} над кінчиком інструмента: вкажіть від 0 до {:g} або виправте [stock] у {}</translation>
    </message>
    <message>
        <source>No remedy: {}</source>
        <translation>Немає поради: {}</translation>
    </message>
    <message>
        <source>the setup</source>
        <translation>налаштуванні</translation>
    </message>
    <message>
        <source>the work frame; the file does not say</source>
        <translation>система деталі; файл не каже</translation>
    </message>
    <message>
        <source>what G330 leads back to</source>
        <translation>те, куди повертає G330</translation>
    </message>
    <message>
        <source>the document's common frame</source>
        <translation>спільна система документа</translation>
    </message>
    <message>
        <source>the work frame in force, as LinuxCNC logs it</source>
        <translation>чинна система деталі, як її записує LinuxCNC</translation>
    </message>
    <message>
        <source>the machine's, brought to the work frame by the offset in the log</source>
        <translation>система верстата, зведена до системи деталі зсувом нуля з журналу</translation>
    </message>
    <message>
        <source>{} is no radius in mm</source>
        <translation>{} не є радіусом у мм</translation>
    </message>
    <message>
        <source>{} belongs to {} or axis: contact points lie on the part already</source>
        <translation>{} належить до {} або до осі: точки дотику вже лежать на деталі</translation>
    </message>
    <message>
        <source>{} is no place</source>
        <translation>{} не є місцем</translation>
    </message>
    <message>
        <source>{} is no angle</source>
        <translation>{} не є кутом</translation>
    </message>
    <message>
        <source>{} is for text that no format covers: leave {} out</source>
        <translation>{} призначено для тексту, якого не охоплює жоден формат: приберіть {}</translation>
    </message>
    <message>
        <source>{}: {} holds one measured part</source>
        <translation>{}: {} містить одну виміряну деталь</translation>
    </message>
    <message>
        <source>{} contradicts {}, whose points are centres of the probe ball</source>
        <translation>{} суперечить {}, точки якого є центрами кульки щупа</translation>
    </message>
    <message>
        <source>not a file</source>
        <translation>не файл</translation>
    </message>
    <message>
        <source>measured part {}</source>
        <translation>виміряна деталь {}</translation>
    </message>
    <message>
        <source>{} features with X and Y and no size are taken for points</source>
        <translation>{} елементів з X і Y без розміру взято за точки</translation>
    </message>
    <message>
        <source>no single column {}: not Calypso's table of characteristics or features; give the file that ends in _chr.txt or _fet.txt, or say by {} what the columns are and which rows are points</source>
        <translation>немає однозначного стовпця {}: це не таблиця характеристик чи елементів Calypso; вкажіть файл, що закінчується на _chr.txt або _fet.txt, або опишіть через {}, що означають стовпці та які рядки є точками</translation>
    </message>
    <message>
        <source>part {}, {}</source>
        <translation>деталь {}, {}</translation>
    </message>
    <message>
        <source>{}: the table does not name their kind</source>
        <translation>{}: таблиця не називає їхнього виду</translation>
    </message>
    <message>
        <source>{} of axis {} is no coordinate</source>
        <translation>{} осі {} не є координатою</translation>
    </message>
    <message>
        <source>no rows below the header</source>
        <translation>немає рядків під заголовком</translation>
    </message>
    <message>
        <source>no row of the kind Point or SpacePoint, only {}</source>
        <translation>немає рядка виду Point чи SpacePoint, лише {}</translation>
    </message>
    <message>
        <source>{} points were not measured</source>
        <translation>{} точок не виміряно</translation>
    </message>
    <message>
        <source>{} other features left out: {}</source>
        <translation>інших елементів пропущено: {}: {}</translation>
    </message>
    <message>
        <source>{} of {} points have no normal: normals are not used</source>
        <translation>{} із {} точок не мають нормалі: нормалі не використано</translation>
    </message>
    <message>
        <source>none of {} features has xValue and yValue and no other characteristic</source>
        <translation>жоден із {} елементів не має xValue і yValue без інших характеристик</translation>
    </message>
    <message>
        <source>{} has no zValue, others have</source>
        <translation>{} не має zValue, інші мають</translation>
    </message>
    <message>
        <source>{} other features left out{}</source>
        <translation>інших елементів пропущено: {}{}</translation>
    </message>
    <message>
        <source>{} columns: the row is incomplete; {}</source>
        <translation>стовпців: {}, рядок неповний; {}</translation>
    </message>
    <message>
        <source>feature {} is there twice, first in line {}</source>
        <translation>елемент {} є двічі, вперше в рядку {}</translation>
    </message>
    <message>
        <source>{} of {} is there twice, first from line {}</source>
        <translation>{} для {} є двічі, вперше від рядка {}</translation>
    </message>
    <message>
        <source>coordinates in different units: export them in one</source>
        <translation>координати в різних одиницях: експортуйте їх в одній</translation>
    </message>
    <message>
        <source>unit {}: only mm and inch are read</source>
        <translation>одиниця {}: читаються лише мм і дюйм</translation>
    </message>
    <message>
        <source>a header</source>
        <translation>заголовок</translation>
    </message>
    <message>
        <source>{}: deviation is not actual less nominal, export the table again</source>
        <translation>{}: відхилення не дорівнює виміряному мінус номінал, експортуйте таблицю ще раз</translation>
    </message>
    <message>
        <source>a PDF document</source>
        <translation>документом PDF</translation>
    </message>
    <message>
        <source>export the points as CSV</source>
        <translation>експортуйте точки як CSV</translation>
    </message>
    <message>
        <source>a ZIP container (a workbook, a FreeCAD document?)</source>
        <translation>архівом ZIP (книга, документ FreeCAD?)</translation>
    </message>
    <message>
        <source>save the points as CSV</source>
        <translation>збережіть точки як CSV</translation>
    </message>
    <message>
        <source>an Excel workbook</source>
        <translation>книгою Excel</translation>
    </message>
    <message>
        <source>compressed (gzip)</source>
        <translation>стиснутим (gzip)</translation>
    </message>
    <message>
        <source>unpack it first</source>
        <translation>спершу розпакуйте його</translation>
    </message>
    <message>
        <source>a PNG picture</source>
        <translation>зображенням PNG</translation>
    </message>
    <message>
        <source>give the measured points</source>
        <translation>вкажіть виміряні точки</translation>
    </message>
    <message>
        <source>a JPEG picture</source>
        <translation>зображенням JPEG</translation>
    </message>
    <message>
        <source>a rich text document</source>
        <translation>документом RTF</translation>
    </message>
    <message>
        <source>save the points as plain text</source>
        <translation>збережіть точки як простий текст</translation>
    </message>
    <message>
        <source>a STEP model</source>
        <translation>моделлю STEP</translation>
    </message>
    <message>
        <source>give the measured points, not the model</source>
        <translation>вкажіть виміряні точки, а не модель</translation>
    </message>
    <message>
        <source>binary data (control character {}): not a text file</source>
        <translation>двійкові дані (керівний символ {}): не текстовий файл</translation>
    </message>
    <message>
        <source>the file is XML or HTML: export the points as text with a header x,y,z</source>
        <translation>файл є XML або HTML: експортуйте точки як текст із заголовком x,y,z</translation>
    </message>
    <message>
        <source>the file holds nothing but blanks</source>
        <translation>файл містить лише пробіли</translation>
    </message>
    <message>
        <source>the file is {}: {}</source>
        <translation>файл є {}: {}</translation>
    </message>
    <message>
        <source>binary or truncated</source>
        <translation>двійковим або обрізаним</translation>
    </message>
    <message>
        <source>the file is {}: no text in {}</source>
        <translation>файл є {}: не текст у {}</translation>
    </message>
    <message>
        <source>the file ends in the middle of a statement: it was cut off</source>
        <translation>файл кінчається посеред оператора: його обрізано</translation>
    </message>
    <message>
        <source>a statement of more than {} characters</source>
        <translation>оператор, довший за {} символів</translation>
    </message>
    <message>
        <source>UNITS/{}: only MM and INCH are read</source>
        <translation>UNITS/{}: читаються лише MM та INCH</translation>
    </message>
    <message>
        <source>the unit changes: export the points in one</source>
        <translation>одиниця змінюється: експортуйте точки в одній</translation>
    </message>
    <message>
        <source>PTDATA without a curve or surface above it</source>
        <translation>PTDATA без кривої чи поверхні над ним</translation>
    </message>
    <message>
        <source>PTDATA of {}</source>
        <translation>PTDATA для {}</translation>
    </message>
    <message>
        <source>{}: neither CART nor POL</source>
        <translation>{}: ні CART, ні POL</translation>
    </message>
    <message>
        <source>{}: {} numbers where 3 or 6 were expected</source>
        <translation>{}: {} чисел там, де очікувано 3 або 6</translation>
    </message>
    <message>
        <source>{} is no number</source>
        <translation>{} не є числом</translation>
    </message>
    <message>
        <source>{} is no length that a machine can travel</source>
        <translation>{} не є довжиною, яку може пройти верстат</translation>
    </message>
    <message>
        <source>, only {}</source>
        <translation>, лише {}</translation>
    </message>
    <message>
        <source>no measured points FA(...)=FEAT/POINT in the file{}</source>
        <translation>у файлі немає виміряних точок FA(...)=FEAT/POINT{}</translation>
    </message>
    <message>
        <source>no ENDFIL: points may be missing at the end of the file</source>
        <translation>немає ENDFIL: наприкінці файлу може бракувати точок</translation>
    </message>
    <message>
        <source>{} repetitions of points left out: they are equal</source>
        <translation>{} повторів точок пропущено: вони однакові</translation>
    </message>
    <message>
        <source>measured features left out: {}</source>
        <translation>пропущено виміряні елементи: {}</translation>
    </message>
    <message>
        <source>{} nominal points were not measured</source>
        <translation>{} номінальних точок не виміряно</translation>
    </message>
    <message>
        <source>{} has no UNITS statement</source>
        <translation>{} не має оператора UNITS</translation>
    </message>
    <message>
        <source>{} is no whole statement: export the file again</source>
        <translation>{} не є цілим оператором: експортуйте файл ще раз</translation>
    </message>
    <message>
        <source>FA({}) is there twice: export every curve once</source>
        <translation>FA({}) є двічі: експортуйте кожну криву один раз</translation>
    </message>
    <message>
        <source>FA({}) is a point and a curve</source>
        <translation>FA({}) є і точкою, і кривою</translation>
    </message>
    <message>
        <source>FA({}) lies elsewhere than in line {}: export every point once</source>
        <translation>FA({}) лежить не там, де в рядку {}: експортуйте кожну точку один раз</translation>
    </message>
    <message>
        <source>work plane {} is not known</source>
        <translation>робоча площина {} невідома</translation>
    </message>
    <message>
        <source>ball compensation changes between the points: export them apart</source>
        <translation>компенсація кульки змінюється між точками: експортуйте їх окремо</translation>
    </message>
    <message>
        <source>no points in the file</source>
        <translation>у файлі немає точок</translation>
    </message>
    <message>
        <source>Z stands in some lines and not in others</source>
        <translation>Z є в одних рядках і немає в інших</translation>
    </message>
    <message>
        <source>point N{:g} is there twice, first in line {}: keep one of them, or give every point a number of its own</source>
        <translation>точка N{:g} є двічі, вперше в рядку {}: залиште одну з них або дайте кожній точці свій номер</translation>
    </message>
    <message>
        <source>{} is no word of a printed point</source>
        <translation>{} не є словом роздрукованої точки</translation>
    </message>
    <message>
        <source>the letter {} is there twice: two lines ran together</source>
        <translation>літера {} є двічі: два рядки злилися</translation>
    </message>
    <message>
        <source>{}{} is no coordinate</source>
        <translation>{}{} не є координатою</translation>
    </message>
    <message>
        <source>a line of {} characters: no print-out, or damaged</source>
        <translation>рядок із {} символів: не роздруківка або пошкоджено</translation>
    </message>
    <message>
        <source>{} is missing: the line is incomplete</source>
        <translation>бракує {}: рядок неповний</translation>
    </message>
    <message>
        <source>{}: decimal points and decimal commas in one file; a spreadsheet may have spoilt it, export again with decimal points</source>
        <translation>{}: десяткові крапки й коми в одному файлі; його могла зіпсувати електронна таблиця, експортуйте ще раз із крапками</translation>
    </message>
    <message>
        <source>a coordinate is missing: delete the row or measure the point again</source>
        <translation>бракує координати: видаліть рядок або виміряйте точку ще раз</translation>
    </message>
    <message>
        <source>{} is no measured value: delete the row or measure the point again</source>
        <translation>{} не є виміряним значенням: видаліть рядок або виміряйте точку ще раз</translation>
    </message>
    <message>
        <source>{} is a date: a spreadsheet has spoilt the number, export again without it</source>
        <translation>{} є датою: число зіпсувала електронна таблиця, експортуйте ще раз без неї</translation>
    </message>
    <message>
        <source>{}: thousands separator or decimal comma? Export with plain decimal points</source>
        <translation>{}: роздільник тисяч чи десяткова кома? Експортуйте з простими десятковими крапками</translation>
    </message>
    <message>
        <source>three decimals, as GRBL prints mm</source>
        <translation>три знаки після коми, як GRBL виводить мм</translation>
    </message>
    <message>
        <source>places farther out than such machines go in inches</source>
        <translation>місця далі, ніж такі верстати ходять у дюймах</translation>
    </message>
    <message>
        <source>machine frame, work offset by {}</source>
        <translation>система верстата, зсув нуля: {}</translation>
    </message>
    <message>
        <source>the touch failed, the ball met nothing: delete the line or measure the point again</source>
        <translation>дотик не вдався, кулька нічого не зустріла: видаліть рядок або виміряйте точку ще раз</translation>
    </message>
    <message>
        <source>no probe report [PRB:x,y,z:1] in the log</source>
        <translation>у журналі немає повідомлення щупа [PRB:x,y,z:1]</translation>
    </message>
    <message>
        <source>{} does not hold $13 and gives four decimals, as GRBL prints inches, and some builds of it mm</source>
        <translation>{} не містить $13 і дає чотири знаки після коми, як GRBL виводить дюйми, а деякі його збірки — мм</translation>
    </message>
    <message>
        <source>WCO of the log</source>
        <translation>WCO з журналу</translation>
    </message>
    <message>
        <source>{} contradicts {}, which holds {}: leave it out</source>
        <translation>{} суперечить {}, де є {}: приберіть це</translation>
    </message>
    <message>
        <source>{} is damaged: log the touches again</source>
        <translation>{} пошкоджено: запишіть дотики ще раз</translation>
    </message>
    <message>
        <source>{} of the log</source>
        <translation>{} з журналу</translation>
    </message>
    <message>
        <source>the $# report in the log does not hold the active {}</source>
        <translation>звіт $# у журналі не містить активного {}</translation>
    </message>
    <message>
        <source>{} is in the machine frame and does not hold the work offset</source>
        <translation>{} записано в системі верстата без зсуву нуля</translation>
    </message>
    <message>
        <source>machine frame, work offset as given</source>
        <translation>система верстата, зсув нуля за вказаним</translation>
    </message>
    <message>
        <source>a height map, touched along Z: it shows the height of a surface and nothing of a contour</source>
        <translation>карта висот із дотиками вздовж Z: вона показує висоту поверхні й нічого про контур</translation>
    </message>
    <message>
        <source>no height in the map: it was not probed yet</source>
        <translation>у карті немає висот: її ще не виміряно</translation>
    </message>
    <message>
        <source>{} of {} places were not touched</source>
        <translation>{} із {} місць не виміряно дотиком</translation>
    </message>
    <message>
        <source>{} is no coordinate</source>
        <translation>{} не є координатою</translation>
    </message>
    <message>
        <source>{:g} by {:g} places are no grid</source>
        <translation>{:g} на {:g} місць — не сітка</translation>
    </message>
    <message>
        <source>a height map begins with three lines: x and y from, to and how many, and z</source>
        <translation>карта висот починається трьома рядками: x і y від, до і скільки, та z</translation>
    </message>
    <message>
        <source>more than the {} places of the grid</source>
        <translation>більше за {} місць сітки</translation>
    </message>
    <message>
        <source>X{:g} Y{:g} where the grid has X{:g} Y{:g}: lines are missing</source>
        <translation>X{:g} Y{:g} там, де сітка має X{:g} Y{:g}: бракує рядків</translation>
    </message>
    <message>
        <source>{} numbers where a height map has three in a line</source>
        <translation>{} чисел там, де карта висот має три в рядку</translation>
    </message>
    <message>
        <source>point {:g}, {:g} is not on the grid</source>
        <translation>точка {:g}, {:g} не на сітці</translation>
    </message>
    <message>
        <source>point {}, {} is there twice</source>
        <translation>точка {}, {} є двічі</translation>
    </message>
    <message>
        <source>a number is too large, or not nine in a row</source>
        <translation>число завелике або в рядку не дев’ять чисел</translation>
    </message>
    <message>
        <source>axis {} moved between the touches: probe with X, Y and Z only</source>
        <translation>вісь {} рухалася між дотиками: вимірюйте лише осями X, Y і Z</translation>
    </message>
    <message>
        <source>other axes stood at {}</source>
        <translation>інші осі стояли на {}</translation>
    </message>
    <message>
        <source>{} numbers where X Y Z A B C U V W make nine: the row is damaged or cut off</source>
        <translation>{} чисел там, де X Y Z A B C U V W — дев’ять: рядок пошкоджено або обрізано</translation>
    </message>
    <message>
        <source> (is it {}?)</source>
        <translation> (це {}?)</translation>
    </message>
    <message>
        <source>the mapping</source>
        <translation>опис стовпців</translation>
    </message>
    <message>
        <source>line {} does not name all columns of {}; lacking: {}</source>
        <translation>рядок {} називає не всі стовпці з {}; бракує: {}</translation>
    </message>
    <message>
        <source>no line names all columns of {}; lacking: {}</source>
        <translation>жоден рядок не називає всіх стовпців із {}; бракує: {}</translation>
    </message>
    <message>
        <source>direction of travel</source>
        <translation>напрям руху</translation>
    </message>
    <message>
        <source>the file ends before line {}, where the mapping has the header</source>
        <translation>файл кінчається до рядка {}, де за описом стовпців є заголовок</translation>
    </message>
    <message>
        <source>{} has a decimal point: the mapping says decimal = {!r}</source>
        <translation>{} має десяткову крапку: опис стовпців каже decimal = {!r}</translation>
    </message>
    <message>
        <source>no points below the header</source>
        <translation>немає точок під заголовком</translation>
    </message>
    <message>
        <source>the mapping {}</source>
        <translation>опис стовпців {}</translation>
    </message>
    <message>
        <source>columns by {}{}</source>
        <translation>стовпці за {}{}</translation>
    </message>
    <message>
        <source>no text in {}, which the mapping says</source>
        <translation>не текст у {}, як каже опис стовпців</translation>
    </message>
    <message>
        <source>the row is incomplete, or the file was cut off</source>
        <translation>рядок неповний або файл обрізано</translation>
    </message>
    <message>
        <source>one too many</source>
        <translation>один зайвий</translation>
    </message>
    <message>
        <source>{} columns where {} were expected: {}; {}</source>
        <translation>{} стовпців там, де очікувано {}: {}; {}</translation>
    </message>
    <message>
        <source>{} columns, but the mapping takes column {}: is the separator {}?</source>
        <translation>{} стовпців, але опис бере стовпець {}: роздільник — {}?</translation>
    </message>
    <message>
        <source>{} is no direction of travel: X+, X-, Y+, Y-, Z+ or Z-</source>
        <translation>{} не є напрямом руху: X+, X-, Y+, Y-, Z+ або Z-</translation>
    </message>
    <message>
        <source>{} is too large</source>
        <translation>{} завелике</translation>
    </message>
    <message>
        <source>{} has a decimal comma: the mapping says decimal = {!r}</source>
        <translation>{} має десяткову кому: опис стовпців каже decimal = {!r}</translation>
    </message>
    <message>
        <source>; there are {}</source>
        <translation>; є {}</translation>
    </message>
    <message>
        <source>no row holds {}, which the mapping asks for{}</source>
        <translation>жоден рядок не містить {}, чого потребує опис стовпців{}</translation>
    </message>
    <message>
        <source>a line of {} characters is no row of numbers</source>
        <translation>рядок із {} символів не є рядком чисел</translation>
    </message>
    <message>
        <source>a mapping</source>
        <translation>описом стовпців</translation>
    </message>
    <message>
        <source>two columns are named {}: give their numbers in the mapping</source>
        <translation>два стовпці мають назву {}: вкажіть у описі їхні номери</translation>
    </message>
    <message>
        <source>converted from a unit of {}</source>
        <translation>перераховано з одиниці {}</translation>
    </message>
    <message>
        <source>comma, semicolon, tab, blank, or one character that is no part of a number</source>
        <translation>comma, semicolon, tab, blank або один символ, що не є частиною числа</translation>
    </message>
    <message>
        <source>point or comma</source>
        <translation>point або comma</translation>
    </message>
    <message>
        <source>the number of a line, from 1</source>
        <translation>номер рядка, від 1</translation>
    </message>
    <message>
        <source>a number of lines, from 0</source>
        <translation>кількість рядків, від 0</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>текст</translation>
    </message>
    <message>
        <source>a list of texts</source>
        <translation>список текстів</translation>
    </message>
    <message>
        <source>the name of an encoding of text</source>
        <translation>назва кодування тексту</translation>
    </message>
    <message>
        <source>mm or inch</source>
        <translation>mm або inch</translation>
    </message>
    <message>
        <source>the millimetres in the unit of the file, such as 0.001</source>
        <translation>міліметри в одиниці файлу, наприклад 0.001</translation>
    </message>
    <message>
        <source>one of {}</source>
        <translation>одне з {}</translation>
    </message>
    <message>
        <source>contact or centre, or axis</source>
        <translation>contact, centre або axis</translation>
    </message>
    <message>
        <source>the radius of the probe ball in mm, up to {:g}</source>
        <translation>радіус кульки щупа в мм, до {:g}</translation>
    </message>
    <message>
        <source>a table</source>
        <translation>таблиця</translation>
    </message>
    <message>
        <source>mapping</source>
        <translation>опису стовпців</translation>
    </message>
    <message>
        <source>[columns] is missing: it says at least which columns are x and y</source>
        <translation>бракує [columns]: там сказано щонайменше, які стовпці є x і y</translation>
    </message>
    <message>
        <source>{} is {}, not {}</source>
        <translation>{} — це {}, а не {}</translation>
    </message>
    <message>
        <source>columns: two are the same column of the file</source>
        <translation>columns: два вказують на той самий стовпець файлу</translation>
    </message>
    <message>
        <source>columns: {} and nominal_{} go together</source>
        <translation>columns: {} і nominal_{} йдуть разом</translation>
    </message>
    <message>
        <source>units and factor say the same twice</source>
        <translation>units і factor кажуть те саме двічі</translation>
    </message>
    <message>
        <source>columns: directions of travel are for points = 'axis'</source>
        <translation>columns: напрями руху належать до points = 'axis'</translation>
    </message>
    <message>
        <source>columns: travel and travel_x say the same twice</source>
        <translation>columns: travel і travel_x кажуть те саме двічі</translation>
    </message>
    <message>
        <source>probe_radius is for points = 'centre'; contact points need none</source>
        <translation>probe_radius належить до points = 'centre'; точки дотику його не потребують</translation>
    </message>
    <message>
        <source>decimal and separator cannot both be the comma</source>
        <translation>decimal і separator не можуть обидва бути комою</translation>
    </message>
    <message>
        <source>columns: {} is none of {}</source>
        <translation>columns: {} не є одним із {}</translation>
    </message>
    <message>
        <source>columns.{} is a name in the header or a number from 1, not {}</source>
        <translation>columns.{} — це назва із заголовка або номер від 1, а не {}</translation>
    </message>
    <message>
        <source>only: {} is a text or a list of texts, not {}</source>
        <translation>only: {} — це текст або список текстів, а не {}</translation>
    </message>
    <message>
        <source>only: {} is no column</source>
        <translation>only: {} не є стовпцем</translation>
    </message>
    <message>
        <source>columns: {} is missing</source>
        <translation>columns: бракує {}</translation>
    </message>
    <message>
        <source>{} must be {}</source>
        <translation>{} має бути: {}</translation>
    </message>
    <message>
        <source>two lengths in mm</source>
        <translation>дві довжини в мм</translation>
    </message>
    <message>
        <source>within {} of the effective radius</source>
        <translation>у межах {} від радіуса спрацювання</translation>
    </message>
    <message>
        <source>as many as directions, at least three</source>
        <translation>стільки ж, скільки напрямів, щонайменше три</translation>
    </message>
    <message>
        <source>angles that increase and stay within one turn</source>
        <translation>зростаючі кути в межах одного оберту</translation>
    </message>
    <message>
        <source>lengths in mm within {} of the effective radius</source>
        <translation>довжини в мм у межах {} від радіуса спрацювання</translation>
    </message>
    <message>
        <source>linear where the directions are not evenly spaced round the turn</source>
        <translation>linear, коли напрями не рівномірні за обертом</translation>
    </message>
    <message>
        <source>{}:{}: a coordinate is not a finite number</source>
        <translation>{}:{}: координата не є скінченним числом</translation>
    </message>
    <message>
        <source>{}: ball radius {} is negative</source>
        <translation>{}: радіус кульки {} від’ємний</translation>
    </message>
    <message>
        <source>{}: {} names for {} points</source>
        <translation>{}: {} назв для {} точок</translation>
    </message>
    <message>
        <source>{}: the radii of a shift along an axis must be above 0 mm</source>
        <translation>{}: радіуси зміщення вздовж осі мають бути понад 0 мм</translation>
    </message>
    <message>
        <source>a length in mm above 0</source>
        <translation>довжина в мм понад 0</translation>
    </message>
    <message>
        <source>given together with radii</source>
        <translation>вказано разом із radii</translation>
    </message>
    <message>
        <source>{}: directions of travel are for points shifted along an axis</source>
        <translation>{}: напрями руху належать до точок, зміщених уздовж осі</translation>
    </message>
    <message>
        <source>{}: the direction of travel has not length 1</source>
        <translation>{}: напрям руху не має довжини 1</translation>
    </message>
    <message>
        <source>number of the point</source>
        <translation>номера точки</translation>
    </message>
    <message>
        <source>radius of the ball</source>
        <translation>радіуса кульки</translation>
    </message>
    <message>
        <source>byte 0x{:02X} among the numbers: transmission has spoilt the line</source>
        <translation>байт 0x{:02X} серед чисел: рядок зіпсувала передача</translation>
    </message>
    <message>
        <source>G801 without its G800 line: a line was lost, send the results again</source>
        <translation>G801 без свого рядка G800: рядок утрачено, надішліть результати ще раз</translation>
    </message>
    <message>
        <source>G801 of point {} follows G800 of point {} in line {}: lines were lost</source>
        <translation>G801 точки {} іде за G800 точки {} у рядку {}: рядки втрачено</translation>
    </message>
    <message>
        <source>ball radius R{:g} is negative</source>
        <translation>радіус кульки R{:g} від’ємний</translation>
    </message>
    <message>
        <source>N{:g} is no number of a point</source>
        <translation>N{:g} не є номером точки</translation>
    </message>
    <message>
        <source>G801 of point {} is missing after its G800 in line {}: send the results again</source>
        <translation>бракує G801 точки {} після її G800 у рядку {}: надішліть результати ще раз</translation>
    </message>
    <message>
        <source>G801 of point {} is missing: the file was cut off after this line</source>
        <translation>бракує G801 точки {}: файл обрізано після цього рядка</translation>
    </message>
    <message>
        <source>, only {} features of probing cycles</source>
        <translation>, лише {} елементів вимірювальних циклів</translation>
    </message>
    <message>
        <source>no measured points G800 and G801 in the file{}: the inspection printed none</source>
        <translation>у файлі немає виміряних точок G800 і G801{}: контроль їх не вивів</translation>
    </message>
    <message>
        <source>{} features of probing cycles left out: COMPONENT, SIZE and POSN blocks</source>
        <translation>{} елементів вимірювальних циклів пропущено: блоки COMPONENT, SIZE і POSN</translation>
    </message>
    <message>
        <source>{} points have a nominal offset O, which is not applied</source>
        <translation>{} точок мають номінальний зсув O, якого не застосовано</translation>
    </message>
    <message>
        <source>no END: points may be missing at the end of the file</source>
        <translation>немає END: наприкінці файлу може бракувати точок</translation>
    </message>
    <message>
        <source>point N{} with the same nominal is there twice, first in line {}: keep one of them</source>
        <translation>точка N{} з тим самим номіналом є двічі, вперше в рядку {}: залиште одну з них</translation>
    </message>
    <message>
        <source>{} points turned back by G330</source>
        <translation>{} точок повернуто назад за G330</translation>
    </message>
    <message>
        <source>{} points shifted by G330, after turning: compare with another export once</source>
        <translation>{} точок зміщено за G330 після повороту: порівняйте раз з іншим експортом</translation>
    </message>
    <message>
        <source>a line of {} characters: no MSR file, or damaged</source>
        <translation>рядок із {} символів: не файл MSR або пошкоджено</translation>
    </message>
    <message>
        <source>{}: {} is no letter with a number</source>
        <translation>{}: {} не є літерою з числом</translation>
    </message>
    <message>
        <source>{} has the letter {} twice: two lines ran together</source>
        <translation>{} має літеру {} двічі: два рядки злилися</translation>
    </message>
    <message>
        <source>{}: {}{} is no length, number or angle</source>
        <translation>{}: {}{} не є довжиною, числом чи кутом</translation>
    </message>
    <message>
        <source>{} lacks {}, {}: the line is incomplete</source>
        <translation>для {} бракує {}, {}: рядок неповний</translation>
    </message>
    <message>
        <source>{} is no line of an MSR file: transmission may have spoilt it</source>
        <translation>{} не є рядком файлу MSR: його могла зіпсувати передача</translation>
    </message>
    <message>
        <source>{} points in lines {} to {}</source>
        <translation>{} точок у рядках від {} до {}</translation>
    </message>
    <message>
        <source>no points</source>
        <translation>немає точок</translation>
    </message>
    <message>
        <source>{} holds {} measured parts ({}): say which with {}</source>
        <translation>{} містить виміряних деталей: {} ({}): вкажіть, яку, через {}</translation>
    </message>
    <message>
        <source>one measured part</source>
        <translation>одну виміряну деталь</translation>
    </message>
    <message>
        <source>{} measured parts, counted from 1</source>
        <translation>виміряних деталей: {}, лік від 1</translation>
    </message>
    <message>
        <source>{}: {} holds {}</source>
        <translation>{}: {} містить {}</translation>
    </message>
    <message>
        <source>{}: {}</source>
        <translation>{}: {}</translation>
    </message>
    <message>
        <source>{} to {}: {}</source>
        <translation>{} до {}: {}</translation>
    </message>
    <message>
        <source>first alignment</source>
        <translation>перше вирівнювання</translation>
    </message>
    <message>
        <source>after {} in line {}</source>
        <translation>після {} у рядку {}</translation>
    </message>
    <message>
        <source>{} lacks {} and is no point</source>
        <translation>для {} бракує {}, це не точка</translation>
    </message>
    <message>
        <source>{} of {}</source>
        <translation>{} з {}</translation>
    </message>
    <message>
        <source>unit {}: only MM and IN are read</source>
        <translation>одиниця {}: читаються лише MM та IN</translation>
    </message>
    <message>
        <source>a row of an axis without column heads (AX NOMINAL ...) above it</source>
        <translation>рядок осі без заголовків стовпців (AX NOMINAL ...) над ним</translation>
    </message>
    <message>
        <source>whose row of axis {} is this? {} in line {} stands between it and {} of line {}: delete what is no line of the report</source>
        <translation>чий це рядок осі {}? {} у рядку {} стоїть між ним і {} з рядка {}: видаліть те, що не є рядком звіту</translation>
    </message>
    <message>
        <source>{} among the values of axis {}: export the report again</source>
        <translation>{} серед значень осі {}: експортуйте звіт ще раз</translation>
    </message>
    <message>
        <source>a value is no length</source>
        <translation>значення не є довжиною</translation>
    </message>
    <message>
        <source>axis {}: DEV is not MEAS - NOMINAL in any way the columns can be read: export it again</source>
        <translation>вісь {}: DEV не дорівнює MEAS - NOMINAL, хоч як читати стовпці: експортуйте ще раз</translation>
    </message>
    <message>
        <source>axis {} of {} is there twice</source>
        <translation>вісь {} для {} є двічі</translation>
    </message>
    <message>
        <source>{} locations left out: {} (line {})</source>
        <translation>положень пропущено: {}: {} (рядок {})</translation>
    </message>
    <message>
        <source>dimensions left out: {}</source>
        <translation>пропущено розміри: {}</translation>
    </message>
    <message>
        <source>no LOCATION OF POINT in the report: report the points' X, Y and Z</source>
        <translation>у звіті немає LOCATION OF POINT: виведіть X, Y і Z точок</translation>
    </message>
    <message>
        <source>points in different units: export them in one</source>
        <translation>точки в різних одиницях: експортуйте їх в одній</translation>
    </message>
    <message>
        <source>{} of {} points have no V: normals are not used</source>
        <translation>{} із {} точок не мають V: нормалі не використано</translation>
    </message>
    <message>
        <source>whose row of axis {} is this? {} in line {} closed {} of line {}</source>
        <translation>чий це рядок осі {}? {} у рядку {} закрив {} з рядка {}</translation>
    </message>
    <message>
        <source>the vector V has no three components</source>
        <translation>вектор V не має трьох складових</translation>
    </message>
    <message>
        <source>no point has all its axes: {}; report X, Y and Z</source>
        <translation>жодна точка не має всіх осей: {}; виведіть X, Y і Z</translation>
    </message>
    <message>
        <source>{} is no row of an axis: export the report again</source>
        <translation>{} не є рядком осі: експортуйте звіт ще раз</translation>
    </message>
    <message>
        <source>no single column {}: print nominal, measured value and deviation</source>
        <translation>немає однозначного стовпця {}: виведіть номінал, виміряне значення і відхилення</translation>
    </message>
    <message>
        <source>{} lies elsewhere than in line {}: report every point once</source>
        <translation>{} лежить не там, де в рядку {}: виведіть кожну точку один раз</translation>
    </message>
    <message>
        <source>X3P file</source>
        <translation>файл X3P</translation>
    </message>
    <message>
        <source>no points: it has {} instead of x, y, z</source>
        <translation>немає точок: файл має {} замість x, y, z</translation>
    </message>
    <message>
        <source>x, y and z are no numbers</source>
        <translation>x, y і z не є числами</translation>
    </message>
    <message>
        <source>the header tells of more elements than the file can hold: it was cut off</source>
        <translation>заголовок називає більше елементів, ніж може бути у файлі: його обрізано</translation>
    </message>
    <message>
        <source>no points: it has no element named vertex</source>
        <translation>немає точок: немає елемента vertex</translation>
    </message>
    <message>
        <source>the corners of a mesh are taken as points</source>
        <translation>вершини сітки взято за точки</translation>
    </message>
    <message>
        <source>the header lacks POINTS or DATA</source>
        <translation>у заголовку бракує POINTS або DATA</translation>
    </message>
    <message>
        <source>the header tells of more points than the file can hold: it was cut off</source>
        <translation>заголовок називає більше точок, ніж може бути у файлі: його обрізано</translation>
    </message>
    <message>
        <source>the header tells of {} numbers a point: it is damaged</source>
        <translation>заголовок називає {} чисел на точку: його пошкоджено</translation>
    </message>
    <message>
        <source>{} points where the header says {}: the file was cut off</source>
        <translation>{} точок там, де заголовок каже {}: файл обрізано</translation>
    </message>
    <message>
        <source>{} scans put together</source>
        <translation>з’єднано сканів: {}</translation>
    </message>
    <message>
        <source>{} layers put together</source>
        <translation>з’єднано шарів: {}</translation>
    </message>
    <message>
        <source>a profile: its X and Z are the contour's X and Y</source>
        <translation>профілограма: її X і Z є X і Y контуру</translation>
    </message>
    <message>
        <source>no {} file</source>
        <translation>не файл {}</translation>
    </message>
    <message>
        <source>{} points without a place left out</source>
        <translation>{} точок без координат пропущено</translation>
    </message>
    <message>
        <source>coordinates are stored in steps of {}, at {}</source>
        <translation>координати збережено з кроком {}, біля {}</translation>
    </message>
    <message>
        <source>the compressed data are damaged or cut off</source>
        <translation>стиснуті дані пошкоджено або обрізано</translation>
    </message>
    <message>
        <source>{} files are read by the Python package {}, which is not installed: pip install {}</source>
        <translation>файли {} читає пакет Python {}, якого не встановлено: pip install {}</translation>
    </message>
    <message>
        <source>{} cannot read it, {}: the file is damaged or cut off</source>
        <translation>{} не може прочитати файл, {}: його пошкоджено або обрізано</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>нічого</translation>
    </message>
    <message>
        <source>the normals are no numbers</source>
        <translation>нормалі не є числами</translation>
    </message>
    <message>
        <source>a scan tells of more points than the file can hold</source>
        <translation>скан називає більше точок, ніж може бути у файлі</translation>
    </message>
    <message>
        <source>probe</source>
        <translation>щупа</translation>
    </message>
    <message>
        <source>{} from {:g} to {:g}</source>
        <translation>{} від {:g} до {:g}</translation>
    </message>
    <message>
        <source>name is a text, not {}</source>
        <translation>name — це текст, а не {}</translation>
    </message>
    <message>
        <source>{} is missing: the two go together</source>
        <translation>бракує {}: вони йдуть разом</translation>
    </message>
    <message>
        <source>interpolation is {}, not {}</source>
        <translation>interpolation — це {}, а не {}</translation>
    </message>
    <message>
        <source>radius is missing: the effective radius of the ball in mm</source>
        <translation>бракує radius: радіус спрацювання кульки в мм</translation>
    </message>
    <message>
        <source>a list of at least 3 numbers</source>
        <translation>список щонайменше з 3 чисел</translation>
    </message>
    <message>
        <source>a list of {} numbers</source>
        <translation>список із {} чисел</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>число</translation>
    </message>
    <message>
        <source>a number is too large</source>
        <translation>число завелике</translation>
    </message>
    <message>
        <source>{} rays that met nothing left out</source>
        <translation>{} променів, що нічого не зустріли, пропущено</translation>
    </message>
    <message>
        <source>no measured points in the file</source>
        <translation>у файлі немає виміряних точок</translation>
    </message>
    <message>
        <source>the head of a scan is not whole: four lines of three numbers, four of four</source>
        <translation>заголовок скану неповний: чотири рядки по три числа, чотири по чотири</translation>
    </message>
    <message>
        <source>the matrix of a scan is no turn and shift</source>
        <translation>матриця скану не є поворотом і зсувом</translation>
    </message>
    <message>
        <source>{} points where {} are announced: the file was cut off</source>
        <translation>{} точок там, де оголошено {}: файл обрізано</translation>
    </message>
    <message>
        <source>{} is no number of points: lines are missing or too many</source>
        <translation>{} не є кількістю точок: рядків бракує або забагато</translation>
    </message>
    <message>
        <source>{} numbers are no point: {}</source>
        <translation>{} чисел — не точка: {}</translation>
    </message>
    <message>
        <source>{} is neither a K field nor a line of values</source>
        <translation>{} не є ні полем K, ні рядком значень</translation>
    </message>
    <message>
        <source>K{}/{} is there twice with different contents</source>
        <translation>K{}/{} є двічі з різним вмістом</translation>
    </message>
    <message>
        <source>a value of characteristic {}, which no K2 field describes</source>
        <translation>значення характеристики {}, якої не описує жодне поле K2</translation>
    </message>
    <message>
        <source>{} values for {} characteristics: the line is incomplete, or this is no line of values</source>
        <translation>{} значень для {} характеристик: рядок неповний або це не рядок значень</translation>
    </message>
    <message>
        <source>K0100 says {} characteristics, there are {}: the file was cut off or put together</source>
        <translation>K0100 каже {} характеристик, а їх {}: файл обрізано або складено з кількох</translation>
    </message>
    <message>
        <source>none of the points was measured on this part</source>
        <translation>жодної з точок на цій деталі не виміряно</translation>
    </message>
    <message>
        <source>{} characteristics are no coordinate of a point</source>
        <translation>{} характеристик не є координатою точки</translation>
    </message>
    <message>
        <source>{} points were not measured on this part</source>
        <translation>{} точок на цій деталі не виміряно</translation>
    </message>
    <message>
        <source>no points: name the characteristics of a point alike with X, Y and Z, such as P1.X, P1.Y, P1.Z</source>
        <translation>немає точок: назвіть характеристики точки однаково з X, Y і Z, наприклад P1.X, P1.Y, P1.Z</translation>
    </message>
    <message>
        <source>no values: the file describes characteristics and holds no results</source>
        <translation>немає значень: файл описує характеристики й не містить результатів</translation>
    </message>
    <message>
        <source>{} of point {} has {} of {} values: the file was cut off, or K0002 256 is missing for a point that was not measured</source>
        <translation>{} точки {} має {} із {} значень: файл обрізано або бракує K0002 256 для невиміряної точки</translation>
    </message>
    <message>
        <source>coordinates in mm and in inch in one file</source>
        <translation>координати в мм і в дюймах в одному файлі</translation>
    </message>
    <message>
        <source>point {} has no Z, others have</source>
        <translation>точка {} не має Z, інші мають</translation>
    </message>
    <message>
        <source>K0100 {} is no number of characteristics</source>
        <translation>K0100 {} не є кількістю характеристик</translation>
    </message>
    <message>
        <source>{} of point {} is there twice, first in line {}</source>
        <translation>{} точки {} є двічі, вперше в рядку {}</translation>
    </message>
    <message>
        <source>part {}</source>
        <translation>деталь {}</translation>
    </message>
    <message>
        <source>the profile values stored in the file</source>
        <translation>значення профілю, збережені у файлі</translation>
    </message>
    <message>
        <source>the file's other points</source>
        <translation>інші точки файлу</translation>
    </message>
    <message>
        <source>result {} in line {}</source>
        <translation>результат {} у рядку {}</translation>
    </message>
    <message>
        <source>more than one primary unit of length</source>
        <translation>більше однієї основної одиниці довжини</translation>
    </message>
    <message>
        <source>{} names no unit of length</source>
        <translation>{} не називає одиниці довжини</translation>
    </message>
    <message>
        <source>unit {} is not among the file's units</source>
        <translation>одиниці {} немає серед одиниць файлу</translation>
    </message>
    <message>
        <source>no measured points; {} measured features without any</source>
        <translation>немає виміряних точок; {} виміряних елементів без них</translation>
    </message>
    <message>
        <source>point set {}: its ProbeRadius is not positive</source>
        <translation>набір точок {}: його ProbeRadius не додатний</translation>
    </message>
    <message>
        <source>points left out: {}</source>
        <translation>пропущено точки: {}</translation>
    </message>
    <message>
        <source>measured point {} has no Location</source>
        <translation>виміряна точка {} не має Location</translation>
    </message>
    <message>
        <source>points {} to {} are wanted of point set {}, which has {}</source>
        <translation>потрібні точки від {} до {} набору точок {}, у якому їх {}</translation>
    </message>
    <message>
        <source>{} locations are taken for what the file's others are</source>
        <translation>{} положень узято за те, чим є інші у файлі</translation>
    </message>
    <message>
        <source>stored profile values differ from (P - N) . n - r by up to {}</source>
        <translation>збережені значення профілю відрізняються від (P - N) . n - r до {}</translation>
    </message>
    <message>
        <source>{} contradicts {}: {} points are ball centres</source>
        <translation>{} суперечить {}: {} точок є центрами кульки</translation>
    </message>
    <message>
        <source>{} contradicts {}: {} are contact points</source>
        <translation>{} суперечить {}: {} є точками дотику</translation>
    </message>
    <message>
        <source>the unit named {} has the factor {:g} to metres, not {:g}: one of them is wrong, export the file again</source>
        <translation>одиниця {} має множник {:g} до метра, а не {:g}: одне з них хибне, експортуйте файл ще раз</translation>
    </message>
    <message>
        <source>{} of {} features</source>
        <translation>{} із {} елементів</translation>
    </message>
    <message>
        <source>feature item {} refers to nominal {}, which is not in the file</source>
        <translation>елемент {} посилається на номінал {}, якого немає у файлі</translation>
    </message>
    <message>
        <source>measured point {} refers to feature item {}, which is not in the file</source>
        <translation>виміряна точка {} посилається на елемент {}, якого немає у файлі</translation>
    </message>
    <message>
        <source>of feature {}</source>
        <translation>елемента {}</translation>
    </message>
    <message>
        <source>point set {}: </source>
        <translation>набір точок {}: </translation>
    </message>
    <message>
        <source>element {}: </source>
        <translation>елемент {}: </translation>
    </message>
    <message>
        <source>{} is no range of points of set {}</source>
        <translation>{} не є діапазоном точок набору {}</translation>
    </message>
    <message>
        <source>{:g} m is no unit of length</source>
        <translation>{:g} м не є одиницею довжини</translation>
    </message>
    <message>
        <source>a feature or point set has no id</source>
        <translation>елемент або набір точок не має id</translation>
    </message>
    <message>
        <source>id {} is there twice, first in line {}</source>
        <translation>id {} є двічі, вперше в рядку {}</translation>
    </message>
    <message>
        <source>a MeasurePoint of feature {} has no Point</source>
        <translation>MeasurePoint елемента {} не має Point</translation>
    </message>
    <message>
        <source>feature {}: Compensated {} is not true or false</source>
        <translation>елемент {}: Compensated {} не є true чи false</translation>
    </message>
    <message>
        <source>a MeasurePoint of feature {} lacks Compensated, or all others do</source>
        <translation>у MeasurePoint елемента {} бракує Compensated або в усіх інших</translation>
    </message>
    <message>
        <source>point set {} has no count</source>
        <translation>набір точок {} не має кількості</translation>
    </message>
    <message>
        <source>point set {} has no Points</source>
        <translation>набір точок {} не має Points</translation>
    </message>
    <message>
        <source>point set {} has its own {}: export the points in the common frame and unit</source>
        <translation>набір точок {} має власне {}: експортуйте точки в спільній системі та одиниці</translation>
    </message>
    <message>
        <source>point set {}: {} {} is not true or false</source>
        <translation>набір точок {}: {} {} не є true чи false</translation>
    </message>
    <message>
        <source>point set {}: {} has {} bytes for {} points</source>
        <translation>набір точок {}: {} має {} байтів для {} точок</translation>
    </message>
    <message>
        <source>{}{} numbers where {} were expected</source>
        <translation>{}{} чисел там, де очікувано {}</translation>
    </message>
    <message>
        <source>{}{:g} is no length that a machine can travel</source>
        <translation>{}{:g} не є довжиною, яку може пройти верстат</translation>
    </message>
    <message>
        <source>point set {}: {} is no base64</source>
        <translation>набір точок {}: {} не є base64</translation>
    </message>
    <message>
        <source>{}{} is no number</source>
        <translation>{}{} не є числом</translation>
    </message>
    <message>
        <source>the measurement</source>
        <translation>вимірювання</translation>
    </message>
    <message>
        <source>{} says nothing of how to read a file; known are {}</source>
        <translation>{} нічого не каже про те, як читати файл; відомі {}</translation>
    </message>
    <message>
        <source>component {}, {}</source>
        <translation>компонент {}, {}</translation>
    </message>
    <message>
        <source>{} is no whole POSN line: print the results again</source>
        <translation>{} не є цілим рядком POSN: роздрукуйте результати ще раз</translation>
    </message>
    <message>
        <source>a POSN line without COMPONENT NO and FEATURE NO above it</source>
        <translation>рядок POSN без COMPONENT NO і FEATURE NO над ним</translation>
    </message>
    <message>
        <source>a value is no length that a machine can travel</source>
        <translation>значення не є довжиною, яку може пройти верстат</translation>
    </message>
    <message>
        <source>axis {}: DEV is not ACTUAL less nominal, the line is damaged</source>
        <translation>вісь {}: DEV не дорівнює ACTUAL мінус номінал, рядок пошкоджено</translation>
    </message>
    <message>
        <source>axis {} of feature {} is there twice</source>
        <translation>вісь {} елемента {} є двічі</translation>
    </message>
    <message>
        <source>none of {} features has POSN X and POSN Y without SIZE: measure the contour by points</source>
        <translation>жоден із {} елементів не має POSN X і POSN Y без SIZE: вимірюйте контур точками</translation>
    </message>
    <message>
        <source>feature {} has no POSN Z, others have</source>
        <translation>елемент {} не має POSN Z, інші мають</translation>
    </message>
    <message>
        <source>component and feature {} are there twice: keep one print-out</source>
        <translation>компонент і елемент {} є двічі: залиште одну роздруківку</translation>
    </message>
    <message>
        <source>{} features left out: measured along one axis only, as feature {} (line {}); print where the ball stood</source>
        <translation>{} елементів пропущено: виміряно лише вздовж однієї осі, як елемент {} (рядок {}); виведіть, де стояла кулька</translation>
    </message>
    <message>
        <source>{} features with a size left out</source>
        <translation>{} елементів із розміром пропущено</translation>
    </message>
    <message>
        <source>{} features have an axis that was not measured (ACTUAL NaN)</source>
        <translation>{} елементів мають вісь, якої не виміряно (ACTUAL NaN)</translation>
    </message>
    <message>
        <source>{} features without POSN of X and Y left out</source>
        <translation>{} елементів без POSN для X і Y пропущено</translation>
    </message>
    <message>
        <source>contact points</source>
        <translation>точками дотику</translation>
    </message>
    <message>
        <source>centres of the probe ball</source>
        <translation>центрами кульки щупа</translation>
    </message>
    <message>
        <source>shifted along an axis</source>
        <translation>зміщеними вздовж осі</translation>
    </message>
    <message>
        <source>normal i,j,k</source>
        <translation>нормаль i,j,k</translation>
    </message>
    <message>
        <source>a line of {} characters: not a measurement file, or damaged</source>
        <translation>рядок із {} символів: не файл вимірювання або пошкоджено</translation>
    </message>
    <message>
        <source>coordinate</source>
        <translation>координата</translation>
    </message>
    <message>
        <source>{} points of another probe ball moved along their normals to {}</source>
        <translation>{} точок іншої кульки щупа зміщено вздовж нормалей до {}</translation>
    </message>
    <message>
        <source>the {} has length {}, not 1: export unit vectors or leave the columns out</source>
        <translation>{}: довжина {}, а не 1: експортуйте одиничні вектори або приберіть стовпці</translation>
    </message>
    <message>
        <source>{} contradicts {}, which says {}</source>
        <translation>{} суперечить {}, де сказано {}</translation>
    </message>
    <message>
        <source>{} contradicts {}, whose points are {}: leave {} out</source>
        <translation>{} суперечить {}, точки якого є {}: приберіть {}</translation>
    </message>
    <message>
        <source>the file does not say whether its coordinates are contact points or centres of the probe ball</source>
        <translation>файл не каже, чи його координати є точками дотику, чи центрами кульки щупа</translation>
    </message>
    <message>
        <source>ball centres need {}, the radius of the probe ball: {} does not say it</source>
        <translation>центри кульки потребують {}, радіуса кульки щупа: {} його не каже</translation>
    </message>
    <message>
        <source>{} contradicts control_radius in the probe's file: leave one of them out</source>
        <translation>{} суперечить control_radius у файлі щупа: приберіть одне з них</translation>
    </message>
    <message>
        <source>{} contradicts {}, which says {}: leave {} out</source>
        <translation>{} суперечить {}, де сказано {}: приберіть {}</translation>
    </message>
    <message>
        <source>a probe radius of {} contradicts {}, which says {}: they differ by more than a calibration can</source>
        <translation>радіус щупа {} суперечить {}, де сказано {}: різниця більша, ніж може дати калібрування</translation>
    </message>
    <message>
        <source>radii by direction do not say by which one the control shifted: add {}</source>
        <translation>радіуси за напрямами не кажуть, на який із них змістила система ЧПК: додайте {}</translation>
    </message>
    <message>
        <source>nominal coordinate</source>
        <translation>номінальна координата</translation>
    </message>
    <message>
        <source>{} is no radius of a probe ball</source>
        <translation>{} не є радіусом кульки щупа</translation>
    </message>
    <message>
        <source>probe balls of {} and {} radius and no normals: give one file a ball</source>
        <translation>кульки щупа з радіусами {} і {} без нормалей: один файл — одна кулька</translation>
    </message>
    <message>
        <source> (or axis)</source>
        <translation> (або вісь)</translation>
    </message>
    <message>
        <source>points shifted along an axis need {}, the radius by which the control shifted them</source>
        <translation>точки, зміщені вздовж осі, потребують {}, радіуса, на який їх змістила система ЧПК</translation>
    </message>
    <message>
        <source>a {} is no length that a machine can travel</source>
        <translation>{}: не довжина, яку може пройти верстат</translation>
    </message>
    <message>
        <source>the file does not say</source>
        <translation>файл не каже</translation>
    </message>
    <message>
        <source>the probe</source>
        <translation>щупа</translation>
    </message>
    <message>
        <source>the {} corners of a mesh of {} facets are taken as points, with its normals</source>
        <translation>{} вершин сітки з {} граней узято за точки з її нормалями</translation>
    </message>
    <message>
        <source>{} corners without a normal left out</source>
        <translation>{} вершин без нормалі пропущено</translation>
    </message>
    <message>
        <source>coordinates are stored in steps of {:.2g} {}, at the farthest</source>
        <translation>координати збережено з кроком {:.2g} {}, у найвіддаленішому місці</translation>
    </message>
    <message>
        <source>a corner is no place</source>
        <translation>вершина не є місцем</translation>
    </message>
    <message>
        <source>{} is no whole facet: damaged or cut off</source>
        <translation>{} не є цілою гранню: пошкоджено або обрізано</translation>
    </message>
    <message>
        <source>no STL file, or one that was cut off: its size does not fit its count of facets</source>
        <translation>не файл STL або обрізаний: його розмір не відповідає кількості граней</translation>
    </message>
    <message>
        <source>the end</source>
        <translation>кінець</translation>
    </message>
    <message>
        <source>{} columns where {} were expected</source>
        <translation>{} стовпців там, де очікувано {}</translation>
    </message>
    <message>
        <source>offset</source>
        <translation>зсув</translation>
    </message>
    <message>
        <source>radii by direction</source>
        <translation>радіуси за напрямами</translation>
    </message>
    <message>
        <source> and </source>
        <translation> і </translation>
    </message>
    <message>
        <source>{}: decimal commas between commas? Export with decimal points, or semicolons between</source>
        <translation>{}: десяткові коми між комами? Експортуйте з крапками або з крапкою з комою між стовпцями</translation>
    </message>
    <message>
        <source>{}: the row is incomplete or the file was cut off; {}</source>
        <translation>{}: рядок неповний або файл обрізано; {}</translation>
    </message>
    <message>
        <source>{} contradicts {}, whose header says {}</source>
        <translation>{} суперечить {}, заголовок якого каже {}</translation>
    </message>
    <message>
        <source>a coordinate is too large</source>
        <translation>координата завелика</translation>
    </message>
    <message>
        <source>points shifted along an axis are kept in the file they came from: leave {} out</source>
        <translation>точки, зміщені вздовж осі, лишаються в своєму файлі: приберіть {}</translation>
    </message>
    <message>
        <source>a text file cannot keep the {} of {}, and the points are wrong without: say {} in its place here, and {} with the written file</source>
        <translation>текстовий файл не збереже {} від {}, а без цього точки хибні: вкажіть тут замість нього {}, а {} — для записаного файлу</translation>
    </message>
    <message>
        <source>{} can be a decimal comma or a thousands separator: export with decimal points, or with semicolons between the columns</source>
        <translation>{} може бути десятковою комою або роздільником тисяч: експортуйте з крапками або з крапкою з комою між стовпцями</translation>
    </message>
    <message>
        <source>expected a header x,y,z or x,y,z,i,j,k above the numbers (or say {})</source>
        <translation>очікувано заголовок x,y,z або x,y,z,i,j,k над числами (або вкажіть {})</translation>
    </message>
    <message>
        <source>{}, found {}</source>
        <translation>{}, знайдено {}</translation>
    </message>
    <message>
        <source>no header: the first column {}, then {}; a header says otherwise</source>
        <translation>немає заголовка: перший стовпець {}, далі {}; заголовок скаже інакше</translation>
    </message>
    <message>
        <source>counts up from {}: the points' numbers</source>
        <translation>рахує від {}: номери точок</translation>
    </message>
    <message>
        <source>{} columns without a header: {}; a mapping for it: {}</source>
        <translation>{} стовпців без заголовка: {}; опис стовпців для нього: {}</translation>
    </message>
    <message>
        <source>no points: the file holds only comments</source>
        <translation>немає точок: файл містить лише коментарі</translation>
    </message>
    <message>
        <source>{}; a mapping for it: {}</source>
        <translation>{}; опис стовпців для нього: {}</translation>
    </message>
    <message>
        <source>unit {}: only mm and inch are read, convert the file</source>
        <translation>одиниця {}: читаються лише мм і дюйм, перерахуйте файл</translation>
    </message>
    <message>
        <source>column {} is missing: a normal needs i,j,k</source>
        <translation>бракує стовпця {}: нормаль потребує i,j,k</translation>
    </message>
    <message>
        <source>columns i and j are missing: a normal needs i,j,k</source>
        <translation>бракує стовпців i та j: нормаль потребує i,j,k</translation>
    </message>
    <message>
        <source>the header gives the columns different units</source>
        <translation>заголовок дає стовпцям різні одиниці</translation>
    </message>
    <message>
        <source>commas without a header can be decimal commas or separators: export with decimal points, or put a header x,y,z above the numbers</source>
        <translation>коми без заголовка можуть бути десятковими або роздільниками: експортуйте з крапками або поставте заголовок x,y,z над числами</translation>
    </message>
    <message>
        <source>a line of {} characters: {}</source>
        <translation>рядок із {} символів: {}</translation>
    </message>
    <message>
        <source>holds words: the points' names</source>
        <translation>містить слова: назви точок</translation>
    </message>
    <message>
        <source>column {} appears twice: rename the one that was not measured</source>
        <translation>стовпець {} є двічі: перейменуйте той, якого не виміряно</translation>
    </message>
    <message>
        <source>too large for a {}</source>
        <translation>завеликий для {}</translation>
    </message>
    <message>
        <source>the {} cannot be read: {}</source>
        <translation>файл {} не вдається прочитати: {}</translation>
    </message>
    <message>
        <source>the {} is no text in UTF-8</source>
        <translation>файл {} не є текстом в UTF-8</translation>
    </message>
    <message>
        <source>no TOML: {}</source>
        <translation>не TOML: {}</translation>
    </message>
    <message>
        <source>no TOML that describes a {}</source>
        <translation>не TOML з даними {}</translation>
    </message>
    <message>
        <source>did you mean {}?</source>
        <translation>можливо, {}?</translation>
    </message>
    <message>
        <source>a {} has {}</source>
        <translation>для {} є {}</translation>
    </message>
    <message>
        <source>{} is no key of a {}: {}</source>
        <translation>{} не є ключем {}: {}</translation>
    </message>
    <message>
        <source>{} places touched twice: the second touch of each counts, the slow one</source>
        <translation>{} місць торкнуто двічі: рахується другий, повільний дотик</translation>
    </message>
    <message>
        <source>{}: the points are shifted along an axis of the machine and are to be turned by {:g} degrees: give the direction of travel of each point, and one radius</source>
        <translation>{}: точки зміщено вздовж осі верстата, а їх треба повернути на {:g} градусів: вкажіть напрям руху кожної точки і один радіус</translation>
    </message>
    <message>
        <source>the file ends within a number: it was cut off, or a spreadsheet dropped the last zeros; export it again, or end the last line</source>
        <translation>файл кінчається посеред числа: його обрізано або електронна таблиця відкинула останні нулі; експортуйте ще раз або закінчіть останній рядок</translation>
    </message>
    <message>
        <source>laid into the work frame at X{:g} Y{:g} Z{:g}{} of the file's frame, as given</source>
        <translation>перенесено в систему деталі в X{:g} Y{:g} Z{:g}{} системи файлу, як указано</translation>
    </message>
    <message>
        <source>, turned by {:g} deg</source>
        <translation>, з поворотом на {:g}°</translation>
    </message>
    <message>
        <source>, the one shown of {}</source>
        <translation>, показаний із {}</translation>
    </message>
    <message>
        <source>sheet {} of the workbook{}</source>
        <translation>аркуш {} книги{}</translation>
    </message>
    <message>
        <source>no workbook</source>
        <translation>не книга</translation>
    </message>
    <message>
        <source>sheet {} is empty: save the workbook with the sheet of the points shown</source>
        <translation>аркуш {} порожній: збережіть книгу з показаним аркушем точок</translation>
    </message>
    <message>
        <source>{} workbooks are read by the Python package {}, which is not installed: pip install {}, or save the points as CSV</source>
        <translation>книги {} читає пакет Python {}, якого не встановлено: pip install {} або збережіть точки як CSV</translation>
    </message>
    <message>
        <source>{} cannot read it, {}: the workbook is damaged or cut off</source>
        <translation>{} не може прочитати її, {}: книгу пошкоджено або обрізано</translation>
    </message>
    <message>
        <source>the {} is damaged or cut off: save it again</source>
        <translation>{}: пошкоджено або обрізано: збережіть ще раз</translation>
    </message>
    <message>
        <source>the {} unpacks to absurd sizes: not one of points</source>
        <translation>{}: розпаковується до неможливих розмірів: не файл точок</translation>
    </message>
    <message>
        <source>the {}'s XML declares a document type: save it again</source>
        <translation>{}: XML оголошує тип документа: збережіть ще раз</translation>
    </message>
    <message>
        <source>the XML declares a document type or an entity, which measurement files do not need: remove it</source>
        <translation>XML оголошує тип документа або сутність, яких файлам вимірювань не треба: приберіть це</translation>
    </message>
    <message>
        <source>damaged</source>
        <translation>пошкоджено</translation>
    </message>
    <message>
        <source>not well-formed XML ({}): the file is damaged or cut off</source>
        <translation>неправильний XML ({}): файл пошкоджено або обрізано</translation>
    </message>
    <message>
        <source>XML in an unknown encoding ({}): save it as UTF-8</source>
        <translation>XML у невідомому кодуванні ({}): збережіть як UTF-8</translation>
    </message>
    <message>
        <source>the XML is {}, not {}</source>
        <translation>XML — це {}, а не {}</translation>
    </message>
    <message>
        <source>{} stands where the text of an element was expected</source>
        <translation>{} стоїть там, де очікувано текст елемента</translation>
    </message>
    <message>
        <source>elements nested deeper than {}: not a measurement file</source>
        <translation>елементи вкладено глибше за {}: не файл вимірювання</translation>
    </message>
    <message>
        <source>the first line does not begin with XYZIJK</source>
        <translation>перший рядок не починається з XYZIJK</translation>
    </message>
    <message>
        <source>{} circles left out: rows of 4 or 7 numbers are no points</source>
        <translation>{} кіл пропущено: рядки з 4 або 7 чисел не є точками</translation>
    </message>
    <message>
        <source>no METRIC in the first line: taken for inch, as PC-DMIS does; {} says otherwise</source>
        <translation>у першому рядку немає METRIC: узято дюйми, як це робить PC-DMIS; {} каже інакше</translation>
    </message>
    <message>
        <source>no points in the file{}</source>
        <translation>у файлі немає точок{}</translation>
    </message>
    <message>
        <source>no METRIC in the first line, which PC-DMIS takes for inch</source>
        <translation>у першому рядку немає METRIC, тож для PC-DMIS це дюйми</translation>
    </message>
    <message>
        <source>{} behind XYZIJK: only METRIC may stand there, in columns 11 to 16</source>
        <translation>{} після XYZIJK: там може стояти лише METRIC, у стовпцях від 11 до 16</translation>
    </message>
    <message>
        <source>METRIC stands in column {} of {}, not 11, where PC-DMIS takes the file for inch</source>
        <translation>METRIC стоїть у стовпці {} файлу {}, а не 11, тож PC-DMIS візьме файл у дюймах</translation>
    </message>
    <message>
        <source>{} numbers: a point has 3, or 6 with its normal</source>
        <translation>{} чисел: точка має 3 або 6 разом із нормаллю</translation>
    </message>
    <message>
        <source>, only circles</source>
        <translation>, лише кола</translation>
    </message>
    <message>
        <source>{} needs measured points: what is predicted is no result of an inspection</source>
        <translation>{} потребує виміряних точок: передбачене не є результатом контролю</translation>
    </message>
    <message>
        <source>Serial production</source>
        <translation>Серійне виробництво</translation>
    </message>
    <message>
        <source>part</source>
        <translation>деталь</translation>
    </message>
    <message>
        <source>time (UTC)</source>
        <translation>час (UTC)</translation>
    </message>
    <message>
        <source>std</source>
        <translation>станд. відх.</translation>
    </message>
    <message>
        <source>height</source>
        <translation>розмах</translation>
    </message>
    <message>
        <source>largest</source>
        <translation>найбільше</translation>
    </message>
    <message>
        <source>smoothed</source>
        <translation>згладжене</translation>
    </message>
    <message>
        <source>correction</source>
        <translation>корекція</translation>
    </message>
    <message>
        <source>decision</source>
        <translation>рішення</translation>
    </message>
    <message>
        <source>First program, SHA-256</source>
        <translation>Перша програма, SHA-256</translation>
    </message>
    <message>
        <source>Program for the next part</source>
        <translation>Програма для наступної деталі</translation>
    </message>
    <message>
        <source>What the machine does</source>
        <translation>Що робить верстат</translation>
    </message>
    <message>
        <source>Settings of part {}</source>
        <translation>Параметри деталі {}</translation>
    </message>
    <message>
        <source>magnification {:g}: must be from 1 to {:.0f}</source>
        <translation>збільшення {:g}: має бути від 1 до {:.0f}</translation>
    </message>
    <message>
        <source>Read back, the program keeps the exact path to {}, within its tolerance of {}.</source>
        <translation>Прочитана назад, програма тримає точну траєкторію в межах {}, у допуску {}.</translation>
    </message>
    <message>
        <source>Read back, the program keeps the exact path to {}, &lt;b&gt;outside&lt;/b&gt; its tolerance of {}.</source>
        <translation>Прочитана назад, програма тримає точну траєкторію в межах {}, &lt;b&gt;поза&lt;/b&gt; допуском {}.</translation>
    </message>
    <message>
        <source>The random part is not known here, so the prediction is too favourable: the next part brings its own, and what was random on this part comes on top.</source>
        <translation>Випадкова частина тут не відома, тож прогноз надто сприятливий: наступна деталь матиме свою, а випадкове цієї деталі додасться.</translation>
    </message>
    <message>
        <source>The emitted program was read back and its path compared with the exact parallel of the compensated profile.</source>
        <translation>Записану програму прочитано назад, а її траєкторію порівняно з точною паралеллю скоригованого профілю.</translation>
    </message>
    <message>
        <source>Side of the cutter</source>
        <translation>Сторона фрези</translation>
    </message>
    <message>
        <source>Alignment</source>
        <translation>Вирівнювання</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Фільтр</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Метод</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Коефіцієнт</translation>
    </message>
    <message>
        <source>Limit of a correction</source>
        <translation>Межа корекції</translation>
    </message>
    <message>
        <source>Dead band</source>
        <translation>Зона нечутливості</translation>
    </message>
    <message>
        <source>Tolerance of the path</source>
        <translation>Допуск траєкторії</translation>
    </message>
    <message>
        <source>Kinds of move written</source>
        <translation>Види записаних рухів</translation>
    </message>
    <message>
        <source>With G41, G42 the program gives</source>
        <translation>З G41, G42 програма задає</translation>
    </message>
    <message>
        <source>Depth along</source>
        <translation>Глибина вздовж</translation>
    </message>
    <message>
        <source>Transfer function</source>
        <translation>Передавальна функція</translation>
    </message>
    <message>
        <source>Stock left on</source>
        <translation>Залишений припуск</translation>
    </message>
    <message>
        <source>Allowance kept</source>
        <translation>Припуск лишається</translation>
    </message>
    <message>
        <source>Share that may be unmeasured</source>
        <translation>Частка, що може бути не виміряна</translation>
    </message>
    <message>
        <source>the cutter's centre</source>
        <translation>центр фрези</translation>
    </message>
    <message>
        <source>Toolpath correction report</source>
        <translation>Звіт про корекцію траєкторії</translation>
    </message>
    <message>
        <source>{} to {}, {} in the mean</source>
        <translation>від {} до {}, у середньому {}</translation>
    </message>
    <message>
        <source>1 move</source>
        <translation>1 рух</translation>
    </message>
    <message>
        <source>{} moves</source>
        <translation>рухів: {}</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Попередження</translation>
    </message>
    <message>
        <source>{} warnings</source>
        <translation>Попереджень: {}</translation>
    </message>
    <message>
        <source>Deviations are signed along the nominal's normal: &lt;b&gt;positive is excess material, negative is undercut&lt;/b&gt;. Deviations in {}, coordinates and lengths in {}.</source>
        <translation>Відхилення рахуються вздовж нормалі номіналу: &lt;b&gt;додатне — зайвий матеріал, від’ємне — підріз&lt;/b&gt;. Відхилення в {}, координати й довжини в {}.</translation>
    </message>
    <message>
        <source>min</source>
        <translation>мін.</translation>
    </message>
    <message>
        <source>max</source>
        <translation>макс.</translation>
    </message>
    <message>
        <source>profile value</source>
        <translation>значення профілю</translation>
    </message>
    <message>
        <source>All by the model: the program as it came, and after the correction, each simulated.</source>
        <translation>Усе за моделлю: програма, якою була, і після корекції, обидві змодельовані.</translation>
    </message>
    <message>
        <source>The profile value is 2·max|d|, to be held against the width of a profile tolerance zone (ISO 1101).</source>
        <translation>Значення профілю — 2·max|d|, його порівнюють із шириною поля допуску профілю (ISO 1101).</translation>
    </message>
    <message>
        <source>The next part brings its own random part: measured the same way, a standard deviation of about &lt;b&gt;{}&lt;/b&gt; is to be expected.</source>
        <translation>Наступна деталь матиме власну випадкову частину: за такого самого вимірювання слід чекати стандартного відхилення близько &lt;b&gt;{}&lt;/b&gt;.</translation>
    </message>
    <message>
        <source>predicted mean</source>
        <translation>очікуване середнє</translation>
    </message>
    <message>
        <source>Deviations on the contour</source>
        <translation>Відхилення на контурі</translation>
    </message>
    <message>
        <source>Contour</source>
        <translation>Контур</translation>
    </message>
    <message>
        <source>point</source>
        <translation>точка</translation>
    </message>
    <message>
        <source>measured / {}</source>
        <translation>виміряно / {}</translation>
    </message>
    <message>
        <source>expected / {}</source>
        <translation>очікується / {}</translation>
    </message>
    <message>
        <source>The program's own path error</source>
        <translation>Власна похибка траєкторії програми</translation>
    </message>
    <message>
        <source>at the points</source>
        <translation>у точках</translation>
    </message>
    <message>
        <source>the contour; the control offsets by the radius</source>
        <translation>контур; ЧПК зміщує на радіус</translation>
    </message>
    <message>
        <source>given</source>
        <translation>задано</translation>
    </message>
    <message>
        <source>the contour that the program cuts</source>
        <translation>контур, який ріже програма</translation>
    </message>
    <message>
        <source>{} measured points ({}) show deviations of {}.</source>
        <translation>Виміряні точки, {} ({}), показують відхилення {}.</translation>
    </message>
    <message>
        <source>No measurement: the path is laid on the exact parallel of the nominal contour.</source>
        <translation>Без вимірювання: траєкторію покладено на точну паралель номінального контуру.</translation>
    </message>
    <message>
        <source>Nothing is to be corrected: &lt;b&gt;the program stays as it is&lt;/b&gt;.</source>
        <translation>Коригувати нічого: &lt;b&gt;програма лишається, якою є&lt;/b&gt;.</translation>
    </message>
    <message>
        <source>largest correction of the contour</source>
        <translation>найбільша корекція контуру</translation>
    </message>
    <message>
        <source>largest path error of the program, read back</source>
        <translation>найбільша похибка траєкторії програми, прочитаної назад</translation>
    </message>
    <message>
        <source>No points were measured.</source>
        <translation>Точок не виміряно.</translation>
    </message>
    <message>
        <source>before</source>
        <translation>до</translation>
    </message>
    <message>
        <source>determined part</source>
        <translation>визначена частина</translation>
    </message>
    <message>
        <source>predicted after</source>
        <translation>очікується після</translation>
    </message>
    <message>
        <source>Predicted: what the model expects at the same points, their random part unchanged.</source>
        <translation>Очікується: те, що модель передбачає в тих самих точках, з незмінною випадковою частиною.</translation>
    </message>
    <message>
        <source>Predicted: the same points after the correction, this part's random part unchanged.</source>
        <translation>Очікується: ті самі точки після корекції, з незмінною випадковою частиною цієї деталі.</translation>
    </message>
    <message>
        <source>What repeats and what does not</source>
        <translation>Що повторюється, а що ні</translation>
    </message>
    <message>
        <source>The correction in force</source>
        <translation>Чинна корекція</translation>
    </message>
    <message>
        <source>Uncertainty of the correction</source>
        <translation>Невизначеність корекції</translation>
    </message>
    <message>
        <source>Largest correction</source>
        <translation>Найбільша корекція</translation>
    </message>
    <message>
        <source>Moves</source>
        <translation>Рухи</translation>
    </message>
    <message>
        <source>{} of the program's moves changed, {} written</source>
        <translation>змінено рухів програми: {}, записано: {}</translation>
    </message>
    <message>
        <source>Largest displacement of a vertex</source>
        <translation>Найбільше зміщення вершини</translation>
    </message>
    <message>
        <source>Largest path error</source>
        <translation>Найбільша похибка траєкторії</translation>
    </message>
    <message>
        <source>Gouge</source>
        <translation>Зарізання</translation>
    </message>
    <message>
        <source>{} nearer to the profile than the cutter's radius at most</source>
        <translation>щонайбільше на {} ближче до профілю, ніж радіус фрези</translation>
    </message>
    <message>
        <source>Profile as NURBS</source>
        <translation>Профіль як NURBS</translation>
    </message>
    <message>
        <source>within {} of the exact compensated contour</source>
        <translation>у межах {} від точного скоригованого контуру</translation>
    </message>
    <message>
        <source>Checked length of path</source>
        <translation>Перевірена довжина траєкторії</translation>
    </message>
    <message>
        <source>Tool diameter</source>
        <translation>Діаметр інструмента</translation>
    </message>
    <message>
        <source>Program gives</source>
        <translation>Програма задає</translation>
    </message>
    <message>
        <source>Nominal</source>
        <translation>Номінал</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Параметри</translation>
    </message>
    <message>
        <source>&lt;b&gt;Nothing was measured&lt;/b&gt;: the model of {} leaves {}.</source>
        <translation>&lt;b&gt;Нічого не виміряно&lt;/b&gt;: модель {} лишає {}.</translation>
    </message>
    <message>
        <source>The model expects at most {} along the whole contour before the correction and {} after it.</source>
        <translation>Модель очікує вздовж усього контуру щонайбільше {} до корекції і {} після неї.</translation>
    </message>
    <message>
        <source>&lt;b&gt;{} of the program change&lt;/b&gt; by the path's own error only.</source>
        <translation>&lt;b&gt;Змінюється в програмі, {}&lt;/b&gt;, лише на власну похибку траєкторії.</translation>
    </message>
    <message>
        <source>&lt;b&gt;The correction moves the contour by up to {}&lt;/b&gt; (at {}) and changes {}.</source>
        <translation>&lt;b&gt;Корекція зсуває контур щонайбільше на {}&lt;/b&gt; (у {}) і змінює {}.</translation>
    </message>
    <message>
        <source>mean deviation, {}, before and predicted</source>
        <translation>середнє відхилення, {}, до і очікуване</translation>
    </message>
    <message>
        <source>height (max − min), {}, before and predicted</source>
        <translation>розмах (макс. − мін.), {}, до і очікуваний</translation>
    </message>
    <message>
        <source>changed in the program</source>
        <translation>змінено в програмі</translation>
    </message>
    <message>
        <source>Deviations</source>
        <translation>Відхилення</translation>
    </message>
    <message>
        <source>contour {}, Z {}</source>
        <translation>контур {}, Z {}</translation>
    </message>
    <message>
        <source>Outliers</source>
        <translation>Викиди</translation>
    </message>
    <message>
        <source>rms</source>
        <translation>середньокв.</translation>
    </message>
    <message>
        <source>Correction</source>
        <translation>Корекція</translation>
    </message>
    <message>
        <source>Verification</source>
        <translation>Перевірка</translation>
    </message>
    <message>
        <source>Aligned by</source>
        <translation>Вирівняно на</translation>
    </message>
    <message>
        <source>Inputs</source>
        <translation>Вхідні дані</translation>
    </message>
    <message>
        <source>Outputs</source>
        <translation>Результати</translation>
    </message>
    <message>
        <source>1 measured point ({}) shows deviations of {}.</source>
        <translation>1 виміряна точка ({}) показує відхилення {}.</translation>
    </message>
    <message>
        <source>Deviation along the contour</source>
        <translation>Відхилення вздовж контуру</translation>
    </message>
    <message>
        <source>Path and contour</source>
        <translation>Траєкторія і контур</translation>
    </message>
    <message>
        <source>Distribution</source>
        <translation>Розподіл</translation>
    </message>
    <message>
        <source>on the profile</source>
        <translation>на профілі</translation>
    </message>
    <message>
        <source>deviation {} ({})</source>
        <translation>відхилення {} ({})</translation>
    </message>
    <message>
        <source>of that determined {}, expected next {}</source>
        <translation>з того визначено {}, далі очікується {}</translation>
    </message>
    <message>
        <source>left out: {}</source>
        <translation>вилучено: {}</translation>
    </message>
    <message>
        <source>{} as measured</source>
        <translation>{} як виміряно</translation>
    </message>
    <message>
        <source>material left</source>
        <translation>залишок матеріалу</translation>
    </message>
    <message>
        <source>undercut</source>
        <translation>підріз</translation>
    </message>
    <message>
        <source>limits {:g} and {:g}: must be from -10 to 10 mm, the upper one above the lower</source>
        <translation>межі {:g} і {:g}: мають бути від -10 до 10 мм, верхня вища за нижню</translation>
    </message>
    <message>
        <source>material left {}: must be {}</source>
        <translation>залишений матеріал {}: має бути {}</translation>
    </message>
    <message>
        <source>Predicted by the model</source>
        <translation>Передбачено моделлю</translation>
    </message>
    <message>
        <source>error expected / {}</source>
        <translation>очікувана похибка / {}</translation>
    </message>
    <message>
        <source>Force, engaged arc and feed</source>
        <translation>Сила, дуга зачеплення і подача</translation>
    </message>
    <message>
        <source>Forces and deflections of the axes</source>
        <translation>Сили і прогини осей</translation>
    </message>
    <message>
        <source>Contours and paths</source>
        <translation>Контури і траєкторії</translation>
    </message>
    <message>
        <source>Setup</source>
        <translation>Налаштування</translation>
    </message>
    <message>
        <source>nothing is to be corrected, the program stays as it is</source>
        <translation>коригувати нічого, програма лишається як є</translation>
    </message>
    <message>
        <source>{}; {:.0f} % of the contour rests on no points</source>
        <translation>{}; {:.0f} % контуру не спирається на точки</translation>
    </message>
    <message>
        <source>use it</source>
        <translation>Застосувати</translation>
    </message>
    <message>
        <source>look at {}</source>
        <translation>Подивитися: {}</translation>
    </message>
    <message>
        <source>{} was accepted and is not resolved</source>
        <translation>{} прийнято й не усунуто</translation>
    </message>
    <message>
        <source>{} of {} points are outliers, there the largest</source>
        <translation>{} з {} точок є викидами, там найбільший</translation>
    </message>
    <message>
        <source>only the path's own error changes</source>
        <translation>змінюється лише власна похибка траєкторії</translation>
    </message>
    <message>
        <source>use it, and measure the first part</source>
        <translation>Застосувати й виміряти першу деталь</translation>
    </message>
    <message>
        <source>{}, by the model alone</source>
        <translation>{}, лише за моделлю</translation>
    </message>
    <message>
        <source>use it if what the warnings ask is answered</source>
        <translation>Застосувати, якщо з'ясовано те, про що питають застереження</translation>
    </message>
    <message>
        <source>measure again or average parts</source>
        <translation>Виміряти знову або усереднити деталі</translation>
    </message>
    <message>
        <source>{} do not repeat, only {} do</source>
        <translation>{} не повторюється, лише {} повторюється</translation>
    </message>
    <message>
        <source>the cut moves up to {} into the material, most at {}</source>
        <translation>різ зміщується до {} у матеріал, найбільше в {}</translation>
    </message>
    <message>
        <source>the cut moves up to {} away from the part, most at {}</source>
        <translation>різ зміщується до {} від деталі, найбільше в {}</translation>
    </message>
    <message>
        <source>legal filters: none, mean:5, mean:1,2,3,2,1 (odd number of weights), gauss:MM, robust:MM, auto</source>
        <translation>дозволені фільтри: none, mean:5, mean:1,2,3,2,1 (непарна кількість ваг), gauss:MM, robust:MM, auto</translation>
    </message>
    <message>
        <source>{} gap(s) without points, the longest {} from s = {}: the deviation there is not known</source>
        <translation>проміжків без точок: {}, найдовший {} від s = {}: відхилення там не відоме</translation>
    </message>
    <message>
        <source>a single point: its deviation is taken as it is, the random part cannot be known</source>
        <translation>одна точка: її відхилення береться як є, випадкову частину не визначити</translation>
    </message>
    <message>
        <source>arc lengths and deviations must be equally long rows, not {}, {}</source>
        <translation>довжини дуг і відхилення мають бути рядами однакової довжини, а не {}, {}</translation>
    </message>
    <message>
        <source>there are no deviations to filter</source>
        <translation>немає відхилень для фільтрування</translation>
    </message>
    <message>
        <source>an arc length or a deviation is not a finite number</source>
        <translation>довжина дуги чи відхилення не є скінченним числом</translation>
    </message>
    <message>
        <source>the length of the stretch must be above 0, not {:g}</source>
        <translation>довжина ділянки має бути більша за 0, а не {:g}</translation>
    </message>
    <message>
        <source>the mask of {} is longer than the row of {} points: cut to {}</source>
        <translation>маска з {} довша за ряд із {} точок: скорочено до {}</translation>
    </message>
    <message>
        <source>the mask is not symmetric: it shifts the deviations along the profile</source>
        <translation>маска не симетрична: вона зсуває відхилення вздовж профілю</translation>
    </message>
    <message>
        <source>the points are unevenly spaced (up to {}, median {}) and the moving average counts points: prefer gauss:MM or auto</source>
        <translation>точки розміщені нерівномірно (до {}, медіана {}), а ковзне середнє рахує точки: краще gauss:MM або auto</translation>
    </message>
    <message>
        <source>the mask sums to 0 at an end of the row: those points are left unfiltered</source>
        <translation>сума маски на кінці ряду 0: ці точки лишаються нефільтрованими</translation>
    </message>
    <message>
        <source>the cutoff of {} is below twice the point spacing ({}): next to nothing is filtered</source>
        <translation>гранична довжина хвилі {} менша за подвійний крок точок ({}): майже нічого не фільтрується</translation>
    </message>
    <message>
        <source>the robust regression did not settle within {} rounds</source>
        <translation>робастна регресія не усталилася за {} проходів</translation>
    </message>
    <message>
        <source>points far off the line, which are outliers and left out: {}</source>
        <translation>точки далеко від лінії, які є викидами й не враховані: {}</translation>
    </message>
    <message>
        <source>unknown filter '{}'; {}</source>
        <translation>невідомий фільтр «{}»; {}</translation>
    </message>
    <message>
        <source>filter '{}' holds a number that is not finite; {}</source>
        <translation>фільтр «{}» містить число, що не є скінченним; {}</translation>
    </message>
    <message>
        <source>filter '{}' has an even number of weights; {}</source>
        <translation>фільтр «{}» має парну кількість ваг; {}</translation>
    </message>
    <message>
        <source>the weights of filter '{}' add up to 0; {}</source>
        <translation>ваги фільтра «{}» дають у сумі 0; {}</translation>
    </message>
    <message>
        <source>the points spread over {} of a stretch of {}</source>
        <translation>точки простягаються на {} ділянки {}</translation>
    </message>
    <message>
        <source>the mask of {} is longer than the row of {} points</source>
        <translation>маска з {} довша за ряд із {} точок</translation>
    </message>
    <message>
        <source>filter '{}' holds something that is not a number; {}</source>
        <translation>фільтр «{}» містить щось, що не є числом; {}</translation>
    </message>
    <message>
        <source>filter '{}' needs one cutoff in mm above 0; {}</source>
        <translation>фільтр «{}» потребує граничної довжини хвилі в мм, більшої за 0; {}</translation>
    </message>
    <message>
        <source>filter '{}' needs an odd whole number of points; {}</source>
        <translation>фільтр «{}» потребує непарного цілого числа точок; {}</translation>
    </message>
    <message>
        <source>part {} was measured at other places than the first: nothing can be averaged</source>
        <translation>деталь {} виміряно в інших місцях, ніж першу: усереднити нічого</translation>
    </message>
    <message>
        <source>{}: the points lie {} off the profile and not {} over it: check {}; it belongs to a part with stock left on it, and {} is then the program that finishes it</source>
        <translation>{}: точки лежать на {} від профілю, а не на {} над ним: перевірте {}; воно належить до деталі з лишеним припуском, і тоді {} є програмою, що її закінчує</translation>
    </message>
    <message>
        <source>what is cut under {} is another part than the measured one, cut under {}: it stays as it is</source>
        <translation>те, що ріжеться під {}, є іншою деталлю, ніж виміряна, різана під {}: воно лишається як є</translation>
    </message>
    <message>
        <source>the diameter of {} is not known</source>
        <translation>діаметр {} невідомий</translation>
    </message>
    <message>
        <source>the tool diameter {} must be a length above 0</source>
        <translation>діаметр інструмента {} має бути довжиною більшою за 0</translation>
    </message>
    <message>
        <source>the same measurement is given twice: averaging needs different parts</source>
        <translation>те саме вимірювання дано двічі: усереднення потребує різних деталей</translation>
    </message>
    <message>
        <source>{} carries the correction from this measurement already, since {}: the part was cut by an earlier program, so all is shown as if this one carried no correction</source>
        <translation>{} вже несе корекцію з цього вимірювання, від {}: деталь вирізано попередньою програмою, тож усе показано так, ніби ця не несе корекції</translation>
    </message>
    <message>
        <source>{}:{}: a part with stock left was cut by a first cut of the uncorrected program: give that as {}, not one that was corrected since</source>
        <translation>{}:{}: деталь із лишеним припуском вирізано першим проходом некоригованої програми: дайте її як {}, а не скориговану відтоді</translation>
    </message>
    <message>
        <source>{} needs {}: one touch or two; without any {}</source>
        <translation>{} потребує {}: одного чи двох дотиків; без них {}</translation>
    </message>
    <message>
        <source>{} takes no {}: with touches use {}</source>
        <translation>{} не приймає {}: з дотиками використайте {}</translation>
    </message>
    <message>
        <source>a first cut that leaves stock is made before anything is measured</source>
        <translation>перший прохід, що лишає припуск, роблять до вимірювання</translation>
    </message>
    <message>
        <source>{}: no move runs along the contour that the points lie on</source>
        <translation>{}: жоден рух не йде вздовж контуру, на якому лежать точки</translation>
    </message>
    <message>
        <source>{}:{}: {} names a corrected program; give the first, uncorrected one</source>
        <translation>{}:{}: {} називає скориговану програму; дайте першу, некориговану</translation>
    </message>
    <message>
        <source>{} or {}: the program has no G41 or G42 that tells the side of the cutter</source>
        <translation>{} або {}: програма не має G41 чи G42, що назвали б бік фрези</translation>
    </message>
    <message>
        <source>{} states it</source>
        <translation>{} називає його</translation>
    </message>
    <message>
        <source>a T word before its cuts gives it a number to state</source>
        <translation>слово T перед його різами дає йому номер, щоб назвати</translation>
    </message>
    <message>
        <source>{}: what it cuts stays as it is and is not looked at; {}</source>
        <translation>{}: що він ріже, лишається як є й не розглядається; {}</translation>
    </message>
    <message>
        <source>{}: the program has no feed move that could follow a contour</source>
        <translation>{}: програма не має робочого руху, що міг би йти за контуром</translation>
    </message>
    <message>
        <source>nothing that runs along a contour is read: {}; write the moves in place of this line, as {}</source>
        <translation>нічого, що йде вздовж контуру, не читається: {}; напишіть рухи замість цього рядка, як {}</translation>
    </message>
    <message>
        <source>{}: a cutter of {} takes no more than its width off; the depth is meant along the contour's normal, from the stock to the surface, in mm</source>
        <translation>{}: фреза {} знімає не більше за свою ширину; глибина розуміється вздовж нормалі контуру, від заготовки до поверхні, у мм</translation>
    </message>
    <message>
        <source>{} is a file; name a directory</source>
        <translation>{} є файлом; назвіть каталог</translation>
    </message>
    <message>
        <source>{}: the report needs a directory, this is a file</source>
        <translation>{}: звіт потребує каталогу, а це файл</translation>
    </message>
    <message>
        <source>{} is the {} itself; the original must stay untouched</source>
        <translation>{} — це сам файл «{}»; оригінал має лишитися як є</translation>
    </message>
    <message>
        <source>{} is a directory; name the file to write</source>
        <translation>{} є каталогом; назвіть файл для запису</translation>
    </message>
    <message>
        <source>{} would replace the {}, {}: name another directory</source>
        <translation>{} замінив би «{}», {}: назвіть інший каталог</translation>
    </message>
    <message>
        <source>{}: cannot be written: {}</source>
        <translation>{}: записати не можна: {}</translation>
    </message>
</context>
</TS>
